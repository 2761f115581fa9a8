// What a test program made by `gliftc test` is built on: checks, and the comparison of two devices. Code that does not
// depend on types is in the runtime, so that not every test program compiles it.
#pragma once

#include <glift/glift.h>
#include <glift/host/math.h>
#include <glift/structure.h>

#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glift {

/// The tolerance between two devices in tests that are not exact (docs/reference/language.md, Accuracy), relative to
/// the larger of 1 and the value.
inline constexpr double inexact_tolerance = 1e-3;
/// The absolute tolerance, in tests that are not exact, of colours that are drawn to channels of eight bits: devices
/// round these in different ways, and again at each blending. Also the tolerance of tests that filter texels of eight
/// bits, relative to the larger of 1 and the value: filters need not be more precise than the texels.
inline constexpr double byte_tolerance = 2.01 / 255.0;

/// A copy of all elements of a structure, of a box or of a buffer, for comparison. `scalars` is the layout of an
/// element: one letter for each scalar (f float, n float in an image of eight-bit channels that draws write, h half, d
/// double, u uint, i int, b bool, U uint64, I int64) and a dot for each byte of padding, which nothing writes.
struct KeptStructure {
    std::string name;
    unsigned rank;
    Extent extent;
    std::string_view scalars;
    std::vector<std::byte> bytes;
};

struct Findings {
    std::vector<std::string> failures;
    std::vector<std::string> notes;    ///< what was not compared or checked
    std::vector<std::string> printed;  ///< what kernels printed, one line each
};

namespace detail {

template <class T> inline constexpr unsigned value_components = 1;
template <class T, unsigned N> inline constexpr unsigned value_components<vec<T, N>> = N;

GLIFT_API std::string number_text(bool value);
GLIFT_API std::string number_text(float value);
GLIFT_API std::string number_text(double value);
GLIFT_API std::string number_text(std::int64_t value);
GLIFT_API std::string number_text(std::uint64_t value);

/// A scalar, a vector or an enumerator's number as text: `2`, `{2, 3}`.
template <class T> std::string value_text(const T& value) {
    if constexpr (std::is_enum_v<T>) return value_text(static_cast<std::underlying_type_t<T>>(value));
    else if constexpr (std::is_same_v<T, half>) return number_text(static_cast<float>(value));
    else if constexpr (std::is_same_v<T, bool> || std::is_floating_point_v<T>) return number_text(value);
    else if constexpr (std::is_unsigned_v<T>) return number_text(std::uint64_t{value});
    else if constexpr (std::is_signed_v<T>) return number_text(std::int64_t{value});
    else {
        std::string text = "{" + value_text(value[0]);
        for (unsigned i = 1; i < value_components<T>; ++i) text += ", " + value_text(value[i]);
        return text + "}";
    }
}

GLIFT_API Extent address_of(std::size_t index, const Extent& extent);

/// Adds the differences between two structures to `failures`: the first few in words, then that there are more.
GLIFT_API void compare(const KeptStructure& a, const std::string& name_a, const KeptStructure& b,
                       const std::string& name_b, double tolerance, const std::string& where,
                       std::vector<std::string>& failures);

/// Compares what kernels printed on two devices, unless some of it was lost: adds the first few differences to
/// `failures`. Numbers in the texts may differ by the tolerance, relative to the largest of 1 and their magnitudes.
GLIFT_API void compare_messages(const std::vector<Message>& a, const std::string& name_a, const std::vector<Message>& b,
                                const std::string& name_b, double tolerance, const std::string& where,
                                std::vector<std::string>& failures);

template <class A> A address_from(const Extent& extent) {
    A address{};
    if constexpr (Axes<A>::count == 1) address = extent[0];
    else
        for (unsigned i = 0; i < Axes<A>::count; ++i) address[i] = extent[i];
    return address;
}

}  // namespace detail

/// One run of one test on one device.
class Test {
public:
    std::vector<std::string> failures;
    std::vector<std::string> notes;  ///< what was not compared or checked
    std::vector<KeptStructure> kept;
    std::vector<Message> messages;  ///< what kernels printed
    /// What each check of a translator with the state of a structure that this test made has found, by its title.
    std::map<std::string, Findings> translations;
    std::map<std::string, std::string> unchecked;  ///< why such a check was not completed, by its title

    /// `text` is the condition as it is written.
    GLIFT_API void expect(bool condition, const char* place, const char* text);
    /// The same for a condition that compares a, written as `left`, and b: if it is false, their values are in the
    /// message.
    template <class A, class B> void expect(bool condition, const char* place, const char* text, const char* left,
                                            const A& a, const char* sign, const B& b) {
        if (condition) return;
        expect(false, place, text);
        failures.back() += std::string(": ") + left + " is " + detail::value_text(a) + ", expected " + sign + " " +
                           detail::value_text(b);
    }

    template <class T> void expect_near(const T& a, const T& b, double tolerance, const char* place) {
        if constexpr (detail::is_scalar<T>) {
            expect_numbers_near(static_cast<double>(a), static_cast<double>(b), tolerance, place);
        } else {
            for (unsigned i = 0; i < detail::value_components<T>; ++i) expect_near(a[i], b[i], tolerance, place);
        }
    }

    /// Compares two structures, or boxes of them, element by element.
    template <class A, class B>
    void expect_same(const A& a, const B& b, std::string_view scalars, const char* place, double tolerance = 0) {
        detail::compare(record("the first", a, scalars), "the first", record("the second", b, scalars), "the second",
                        tolerance, std::string(place) + ": expect_same", failures);
    }

    /// Keeps all elements of a structure, to be compared with those of another device. Returns false, and keeps
    /// nothing, where the structure does not lie in rows of a buffer and its domain is too large to read address by
    /// address (largest_kept): then the caller keeps the structure's memories and nested structures instead. Returns
    /// true, though nothing is kept, for a default-constructed structure, and, with a note, for one in rows of a buffer
    /// that is larger than largest_compared, and for one over memory that a container has given up.
    template <class S> bool keep(const char* name, const S& structure, std::string_view scalars) {
        if (!structure) return true;
        const Extent domain = detail::extent_of(structure.domain());
        if constexpr (requires { structure.row_memory(); }) {
            if (detail::volume_of(domain) > largest_compared / sizeof(typename S::Element)) {
                notes.push_back(std::string("not compared: ") + name + ", which has more than 4 GiB");
                return true;
            }
        } else {
            if (detail::volume_of(domain) > largest_kept / sizeof(typename S::Element)) {
                notes.push_back(std::string(name) + ": its domain is " +
                                detail::text_of(domain, detail::Axes<typename S::Address>::count) +
                                ", too large to compare address by address, so its memories were compared");
                return false;
            }
        }
        try {
            kept.push_back(record(name, structure, scalars));
        } catch (const Error& error) {
            note_given_up(name, error);
        }
        return true;
    }

    /// Keeps the elements of a buffer in the order in which they lie there. Notes that an image, a buffer that is
    /// larger than largest_compared, or memory that a container has given up, was not compared.
    GLIFT_API void keep_memory(const Commands& commands, const char* name, const Memory& memory,
                               std::string_view scalars);

    /// A structure made with arguments that the checks choose; nullopt where the device or the structure refuses the
    /// arguments.
    template <class S, class... Arguments>
    std::optional<S> make(const Commands& commands, const Arguments&... arguments) {
        try {
            std::optional<S> made(std::in_place, commands, arguments...);
            ++made_;
            return made;
        } catch (const Error& error) {
            refused_ = error.problem() + (error.why().empty() ? "" : ": " + error.why());
            return std::nullopt;
        }
    }
    /// Why no call of `make` has made anything; empty if one did, or if `make` was not called.
    std::string why_nothing_was_made() const { return made_ == 0 ? refused_ : std::string(); }

    /// Runs `check`, which checks a translation with the state of a structure that this test made. `path` names the
    /// structure in the test: failures of members (`grid.field`) end with it. An Error that it throws goes into
    /// `unchecked`.
    template <class Check> void check_as_made(const char* title, const char* path, const Check& check) {
        check_as_made(
            title, path, [](const void* body) { (*static_cast<const Check*>(body))(); }, &check);
    }

private:
    /// Notes that the structure or memory was not compared if that is the error; else throws it.
    GLIFT_API void note_given_up(const char* name, const Error& error);

    static constexpr std::uint64_t largest_kept = 1u << 28;                    ///< bytes, read address by address
    static constexpr std::uint64_t largest_compared = std::uint64_t{4} << 30;  ///< bytes of one buffer

    GLIFT_API void expect_numbers_near(double a, double b, double tolerance, const char* place);
    /// What the template above calls. The check's findings go into `translations`.
    GLIFT_API void check_as_made(const char* title, const char* path, void (*check)(const void* body),
                                 const void* body);

    template <class S> static KeptStructure record(const char* name, const S& structure, std::string_view scalars) {
        Extent extent;
        if constexpr (requires { structure.size(); }) extent = detail::extent_of(structure.size());
        else extent = detail::extent_of(structure.domain());
        if (detail::volume_of(extent) > std::uint64_t{largest_kept} * 16)
            throw Error(ErrorCode::too_large, std::string(name) + " has too many elements to be read as a whole", {},
                        {}, "compare a box of it");
        const auto values = structure.read();
        const auto bytes = std::as_bytes(std::span(values));
        return {name, detail::Axes<typename S::Address>::count, extent, scalars, {bytes.begin(), bytes.end()}};
    }

    unsigned made_ = 0;
    std::string refused_;
};

namespace detail {
GLIFT_API void fail_box(Test& test, const char* name, unsigned rank, const Extent& size, const Extent& origin,
                        const Extent& wrong, const Extent& domain);
}

/// Checks with one box that writing a box reaches each of its elements and no others: what is written to the box is
/// read back, and nothing else changes. The elements then get back the values that they had, since another structure
/// may translate by them. Does nothing where the domain is empty or has more than 2^20 elements.
template <class S, class Value> void check_boxes(Test& test, const char* name, S& structure, const Value& value) {
    using A = typename S::Address;
    using T = typename S::Element;
    constexpr unsigned rank = detail::Axes<A>::count;
    const Extent domain = detail::extent_of(structure.domain());
    if (detail::volume_of(domain) == 0 || detail::volume_of(domain) > 1u << 20) return;
    const std::vector<T> before = structure.read();
    std::vector<T> all(detail::volume_of(domain));
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = value(static_cast<std::uint32_t>(i));
    structure.write(all);
    Extent origin{}, size{1, 1, 1, 1};
    for (unsigned i = 0; i < rank; ++i) {
        origin[i] = domain[i] / 3;
        size[i] = std::max(1u, domain[i] / 2);
    }
    std::vector<T> part(detail::volume_of(size));
    for (std::size_t i = 0; i < part.size(); ++i) part[i] = value(static_cast<std::uint32_t>(100000 + i));
    structure.write(detail::address_from<A>(origin), detail::address_from<A>(size), part);
    for (std::size_t i = 0; i < part.size(); ++i) {
        const Extent in = detail::address_of(i, size);
        std::size_t index = 0;
        for (unsigned axis = rank; axis-- > 0;) index = index * domain[axis] + origin[axis] + in[axis];
        all[index] = part[i];
    }
    const std::vector<T> out = structure.read();
    structure.write(before);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (std::memcmp(&all[i], &out[i], sizeof(T)) == 0) continue;
        return detail::fail_box(test, name, rank, size, origin, detail::address_of(i, domain), domain);
    }
}

struct TestCase {
    const char* title;
    const char* place;  ///< file:line
    double tolerance;   ///< between devices; 0: they agree bit for bit
    /// Null: the case is a translator that is checked, if at all, with structures that the other tests make.
    void (*run)(Test& test, const Commands& commands);
    const char* why_not_alone = "";  ///< if `run` is null: why it cannot be checked by itself
};

/// `program [--filter TEXT] [--device NAME]`: runs the tests whose titles contain TEXT on the host device and, unless
/// NAME is `host`, on the device of that name (Device::open), and compares what they leave behind. Returns the exit
/// code: 0, or 1 if a test failed or a device could not be opened.
GLIFT_API int run_tests(std::span<const TestCase> tests, int argc, char** argv);

}  // namespace glift
