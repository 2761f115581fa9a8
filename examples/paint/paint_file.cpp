#include "paint_file.h"

#include "history.h"

#include "examples/common/new_file.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <vector>

namespace paint_file {

namespace {

using Word = glift::uint;
using Words = std::vector<Word>;

static_assert(std::endian::native == std::endian::little, "files are little-endian");

constexpr Word magic[2] = {0x46494c47u, 0x50443354u};  // "GLIF", "T3DP"
constexpr Word version = 2, cells = 16, texels_of_page = 17 * 17 * 17;
constexpr std::size_t header_words = 16, used_words = 9, page_words = texels_of_page + 1;
constexpr Word most_levels = 8, most_at_once = 1024;

/// The checksum of words and of those before them, whose checksum is `before` (0: there are none).
Word checksum(std::span<const Word> words, Word before = 0) {
    return static_cast<Word>(crc32_z(before, reinterpret_cast<const Bytef*>(words.data()), words.size_bytes()));
}

/// The checksum of a page's number and texels: with the number, so that pages that changed places are found.
Word checksum_of_page(Word number, std::span<const Word> texels) { return checksum(texels, checksum({&number, 1})); }

Word pages_of(Word levels) { return ((1u << 3 * levels) - 1) / 7; }

/// The page of the next coarser level that a page lies in; for the coarsest page, that page itself.
Word parent_of(Word page) {
    if (page == 0) return 0;
    Word depth = 1;
    while (page >= pages_of(depth + 1)) ++depth;
    const Word inside = page - pages_of(depth), along = 1u << depth, half = along / 2;
    const Word x = inside % along / 2, y = inside / along % along / 2, z = inside / along / along / 2;
    return pages_of(depth - 1) + x + half * (y + half * z);
}

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw std::runtime_error(path + ": " + what);
}

void write(NewFile& file, Words words, Word check) {
    words.push_back(check);
    file.write(std::as_bytes(std::span(words)));
}

Words header_of(const Header& header) {
    Words words(header_words - 1, 0);
    std::ranges::copy(magic, words.begin());
    words[2] = version;
    words[3] = header.levels;
    words[4] = cells;
    words[5] = header.pages;
    for (unsigned i = 0; i < 3; ++i) words[6 + i] = std::bit_cast<Word>(header.ground[i]);
    return words;
}

/// The words of a file, or of its beginning.
struct Contents {
    Words words;
    std::size_t bytes = 0;  ///< of the whole file
};

Contents read(const std::string& path, std::size_t most_words) {
    // A folder can be opened, and its length is then reported as the largest offset that there is.
    if (std::filesystem::is_directory(path)) refuse(path, "is a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse(path, "cannot be opened");
    file.seekg(0, std::ios::end);
    const std::streamoff bytes = file.tellg();
    if (bytes < 0) refuse(path, "cannot be read: its length is not known");
    Contents contents{{}, static_cast<std::size_t>(bytes)};
    file.seekg(0);
    contents.words.resize(std::min(contents.bytes / 4, most_words));
    file.read(reinterpret_cast<char*>(contents.words.data()), static_cast<std::streamsize>(4 * contents.words.size()));
    if (!file) refuse(path, "cannot be read");
    return contents;
}

std::size_t words_of(const Header& header) {
    return header_words + header.pages + 1 + std::size_t{header.pages} * page_words;
}

bool is_ground(const glift::float3& colour) {
    const auto is_part = [](float x) { return x >= 0 && x <= 1; };  // false for NaN
    return is_part(colour.x) && is_part(colour.y) && is_part(colour.z);
}

Header checked_header(const std::string& path, std::span<const Word> words, std::size_t bytes) {
    if (words.size() < header_words) refuse(path, "is truncated: the header is not whole");
    if (bytes % 4 != 0) refuse(path, "is truncated: its length is no number of words");
    if (!std::equal(std::begin(magic), std::end(magic), words.begin())) refuse(path, "is no file of 3-D paint");
    if (words[2] != version)
        refuse(path, "is of version " + std::to_string(words[2]) + ", and this program reads version " +
                         std::to_string(version));
    if (checksum({words.data(), header_words - 1}) != words[header_words - 1])
        refuse(path, "is damaged: the header's checksum does not match");
    const Header header{
        words[3],
        words[5],
        {std::bit_cast<float>(words[6]), std::bit_cast<float>(words[7]), std::bit_cast<float>(words[8])}};
    if (header.levels == 0 || header.levels > most_levels || words[4] != cells || header.pages == 0 ||
        header.pages > pages_of(header.levels))
        refuse(path, "has a header that no octree has");
    if (!is_ground(header.ground)) refuse(path, "has a ground that is no colour");
    const std::span<const Word> reserved = words.subspan(used_words, header_words - 1 - used_words);
    if (std::ranges::any_of(reserved, [](Word word) { return word != 0; }))
        refuse(path, "has words in its header that this program does not know");
    if (bytes != 4 * words_of(header))
        refuse(path, (bytes < 4 * words_of(header) ? "is truncated: it has " : "has bytes too many: ") +
                         std::to_string(bytes) + " bytes of " + std::to_string(4 * words_of(header)));
    return header;
}

/// Whether an octree of so many levels may have these pages: ascending, and each with the page that it lies in.
bool is_page_table(std::span<const Word> pages, Word levels) {
    for (std::size_t i = 0; i < pages.size(); ++i) {
        if (pages[i] >= pages_of(levels) || (i > 0 && pages[i - 1] >= pages[i])) return false;
        if (!std::ranges::binary_search(pages.first(i + 1), parent_of(pages[i]))) return false;
    }
    return true;
}

/// Checks all that follows the header, and returns the numbers of the pages.
std::span<const Word> checked_pages(const std::string& path, const Header& header, std::span<const Word> words) {
    if (words.size() != words_of(header)) refuse(path, "cannot be read: its length has changed");
    const std::span<const Word> pages = words.subspan(header_words, header.pages);
    if (checksum(pages) != words[header_words + header.pages])
        refuse(path, "is damaged: the page table's checksum does not match");
    if (!is_page_table(pages, header.levels)) refuse(path, "has a page table that no octree has");
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const Word* page = words.data() + header_words + pages.size() + 1 + i * page_words;
        if (checksum_of_page(pages[i], {page, texels_of_page}) != page[texels_of_page])
            refuse(path, "is damaged: the checksum of page " + std::to_string(pages[i]) + " does not match");
    }
    return pages;
}

void check_fit(const std::string& path, const Header& header, const journal::Octree& octree) {
    if (header.levels != octree.levels())
        refuse(path, "is paint of " + std::to_string(cells << (header.levels - 1)) + "^3, and the octree has " +
                         std::to_string(cells << (octree.levels() - 1)) + "^3: choose that --resolution");
    if (header.pages > octree.capacity())
        refuse(path, "has " + std::to_string(header.pages) + " pages, and there may be " +
                         std::to_string(octree.capacity()) + ": give more of them by --pages");
}

journal::PageList list_of(const glift::Device& device, std::span<const Word> pages) {
    journal::PageList list(device, static_cast<Word>(pages.size()));
    list.write(pages);
    return list;
}

/// Calls work(part, index of its first page) for parts of a list, so that the device needs room for the texels of
/// `most_at_once` pages only.
template <class Work> void in_parts(std::span<const Word> pages, const Work& work) {
    for (std::size_t at = 0; at < pages.size(); at += most_at_once)
        work(std::span(pages).subspan(at, std::min<std::size_t>(most_at_once, pages.size() - at)), at);
}

}  // namespace

void save(const std::string& path, const glift::Device& device, journal::Octree& octree, const glift::float3& ground) {
    const Word n = octree.status(device).resident;
    const Words pages = n == 0 ? Words() : octree.pages().active().read(0, n);
    NewFile file(path);
    const Words header = header_of({octree.levels(), n, ground});
    write(file, header, checksum(header));
    write(file, pages, checksum(pages));
    in_parts(pages, [&](std::span<const Word> part, std::size_t) {
        journal::Texels texels(device, {texels_of_page, static_cast<Word>(part.size())});
        mark(device, octree, list_of(device, part));
        journal::store(device, octree, octree.frames(), texels);
        const Words all = texels.read();
        for (std::size_t i = 0; i < part.size(); ++i) {
            const std::span<const Word> page = std::span(all).subspan(i * texels_of_page, texels_of_page);
            write(file, Words(page.begin(), page.end()), checksum_of_page(part[i], page));
        }
    });
    file.take_name();
}

Header check(const std::string& path, std::span<const glift::uint> words, std::size_t bytes) {
    const Header header = checked_header(path, words, bytes);
    checked_pages(path, header, words);
    return header;
}

Header load(const std::string& path, const glift::Device& device, journal::Octree& octree) {
    // The header first: a file that is not of paint, or does not fit, may be too large to be read whole.
    const Contents beginning = read(path, header_words);
    const Header header = checked_header(path, beginning.words, beginning.bytes);
    check_fit(path, header, octree);
    const Words words = read(path, words_of(header)).words;
    if (!std::ranges::equal(beginning.words, std::span(words).first(std::min(words.size(), header_words))))
        refuse(path, "cannot be read: it has changed meanwhile");
    const std::span<const Word> pages = checked_pages(path, header, words);
    octree.pages().request_pages(device, list_of(device, pages));
    octree.update(device);
    in_parts(pages, [&](std::span<const Word> part, std::size_t at) {
        journal::Texels texels(device, {texels_of_page, static_cast<Word>(part.size())});
        Words all;
        for (std::size_t i = at; i < at + part.size(); ++i) {
            const auto first =
                words.begin() + static_cast<std::ptrdiff_t>(header_words + pages.size() + 1 + i * page_words);
            all.insert(all.end(), first, first + texels_of_page);
        }
        texels.write(all);
        mark(device, octree, list_of(device, part));
        journal::restore(device, octree, texels);
    });
    return header;
}

}  // namespace paint_file
