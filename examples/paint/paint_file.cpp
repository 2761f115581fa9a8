#include "paint_file.h"

#include "history.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
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
constexpr Word version = 1, cells = 16, texels_of_page = 17 * 17 * 17;
constexpr std::size_t header_words = 16, page_words = texels_of_page + 1;
constexpr Word most_levels = 8, most_at_once = 1024;

Word checksum(std::span<const Word> words) {
    return static_cast<Word>(crc32_z(0, reinterpret_cast<const Bytef*>(words.data()), words.size_bytes()));
}

Word pages_of(Word levels) { return ((1u << 3 * levels) - 1) / 7; }

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw std::runtime_error(path + ": " + what);
}

/// A file that is written under a temporary name; the destructor deletes it unless take_name() has renamed it.
class NewFile {
public:
    explicit NewFile(std::string path)
        : path_(std::move(path)), name_(path_ + ".new"),
          file_(::open(name_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
        if (file_ < 0) fail("cannot be made");
    }
    ~NewFile() {
        if (file_ >= 0) {
            ::close(file_);
            ::unlink(name_.c_str());
        }
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    void write(std::span<const Word> words) {
        const std::span<const std::byte> bytes = std::as_bytes(words);
        for (std::size_t at = 0; at < bytes.size();) {
            const ssize_t n = ::write(file_, bytes.data() + at, bytes.size() - at);
            if (n < 0 && errno == EINTR) continue;
            if (n <= 0) fail("cannot be written");
            at += static_cast<std::size_t>(n);
        }
    }
    void write_with_checksum(Words words) {
        words.push_back(checksum(words));
        write(words);
    }
    /// Gives the file its name, in place of an old file. Its contents are on the disk before that.
    void take_name() {
        if (::fsync(file_) != 0) fail("cannot be written");
        if (::rename(name_.c_str(), path_.c_str()) != 0) fail("cannot be renamed");
        ::close(file_);
        file_ = -1;
    }

private:
    [[noreturn]] void fail(const char* what) const { refuse(name_, std::string(what) + ": " + std::strerror(errno)); }

    std::string path_, name_;
    int file_;
};

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
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse(path, "cannot be opened");
    file.seekg(0, std::ios::end);
    Contents contents{{}, static_cast<std::size_t>(file.tellg())};
    file.seekg(0);
    contents.words.resize(std::min(contents.bytes / 4, most_words));
    file.read(reinterpret_cast<char*>(contents.words.data()), static_cast<std::streamsize>(4 * contents.words.size()));
    if (!file) refuse(path, "cannot be read");
    return contents;
}

Header checked_header(const std::string& path, std::span<const Word> words, std::size_t bytes) {
    if (words.size() < header_words) refuse(path, "is truncated: the header is not whole");
    if (bytes % 4 != 0) refuse(path, "is truncated: its length is no number of words");
    if (!std::equal(std::begin(magic), std::end(magic), words.begin())) refuse(path, "is no file of 3-D paint");
    if (words[2] != version)
        refuse(path, "is of version " + std::to_string(words[2]) + ", and this program reads version 1");
    if (checksum({words.data(), header_words - 1}) != words[header_words - 1])
        refuse(path, "is damaged: the header's checksum does not match");
    const Header header{
        words[3],
        words[5],
        {std::bit_cast<float>(words[6]), std::bit_cast<float>(words[7]), std::bit_cast<float>(words[8])}};
    if (header.levels == 0 || header.levels > most_levels || words[4] != cells || header.pages == 0 ||
        header.pages > pages_of(header.levels))
        refuse(path, "has a header that no octree has");
    return header;
}

/// Checks all that follows the header, and returns the numbers of the pages.
std::span<const Word> checked_pages(const std::string& path, const Header& header, std::span<const Word> words) {
    const std::size_t wanted = header_words + header.pages + 1 + std::size_t{header.pages} * page_words;
    if (words.size() != wanted)
        refuse(path, (words.size() < wanted ? "is truncated: it has " : "has bytes too many: ") +
                         std::to_string(4 * words.size()) + " bytes of " + std::to_string(4 * wanted));
    const std::span<const Word> pages = words.subspan(header_words, header.pages);
    if (checksum(pages) != words[header_words + header.pages])
        refuse(path, "is damaged: the page table's checksum does not match");
    for (std::size_t i = 0; i < pages.size(); ++i)
        if (pages[i] >= pages_of(header.levels) || (i > 0 && pages[i - 1] >= pages[i]))
            refuse(path, "has a page table that no octree has");
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const Word* page = words.data() + header_words + pages.size() + 1 + i * page_words;
        if (checksum({page, texels_of_page}) != page[texels_of_page])
            refuse(path, "is damaged: the checksum of page " + std::to_string(pages[i]) + " does not match");
    }
    return pages;
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
    file.write_with_checksum(header_of({octree.levels(), n, ground}));
    file.write_with_checksum(pages);
    in_parts(pages, [&](std::span<const Word> part, std::size_t) {
        journal::Texels texels(device, {texels_of_page, static_cast<Word>(part.size())});
        mark(device, octree, list_of(device, part));
        journal::store(device, octree, octree.frames(), texels);
        const Words all = texels.read();
        for (std::size_t i = 0; i < part.size(); ++i)
            file.write_with_checksum(Words(all.begin() + static_cast<std::ptrdiff_t>(i * texels_of_page),
                                           all.begin() + static_cast<std::ptrdiff_t>((i + 1) * texels_of_page)));
    });
    file.take_name();
}

Header read_header(const std::string& path) {
    const Contents contents = read(path, header_words);
    return checked_header(path, contents.words, contents.bytes);
}

Header check(const std::string& path, std::span<const glift::uint> words, std::size_t bytes) {
    const Header header = checked_header(path, words, bytes);
    checked_pages(path, header, words);
    return header;
}

Header load(const std::string& path, const glift::Device& device, journal::Octree& octree) {
    const Contents contents = read(path, SIZE_MAX);
    const Words& words = contents.words;
    const Header header = checked_header(path, words, contents.bytes);
    const std::span<const Word> pages = checked_pages(path, header, words);
    if (header.levels != octree.levels())
        refuse(path, "is paint of " + std::to_string(cells << (header.levels - 1)) + "^3, and the octree has " +
                         std::to_string(cells << (octree.levels() - 1)) + "^3: choose that --resolution");
    if (header.pages > octree.capacity())
        refuse(path, "has " + std::to_string(header.pages) + " pages, and there may be " +
                         std::to_string(octree.capacity()) + ": give more of them by --pages");
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
