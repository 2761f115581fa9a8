// What a test program made by `gliftc test` is built on: checks, and the comparison of two devices.
#pragma once

#include <glift/glift.h>
#include <glift/host/math.h>
#include <glift/structure.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glift {

/// How far two devices may differ where a test uses functions that are not exact (docs/language.md, Accuracy): by this
/// much of the larger of 1 and the value.
inline constexpr double inexact_tolerance = 1e-3;

/// All elements of one structure at the end of a test, with how to read their bytes: one letter a scalar (f float, h
/// half, d double, u uint, i int, b bool, U uint64, I int64), a point for each byte of padding, which nothing writes.
struct KeptStructure {
    std::string name;
    unsigned rank;
    Extent extent;
    std::string_view scalars;
    std::vector<std::byte> bytes;
};

namespace detail {

template <class T> inline constexpr unsigned value_components = 1;
template <class T, unsigned N> inline constexpr unsigned value_components<vec<T, N>> = N;

struct ScalarReader {
    static std::size_t size_of(char kind) {
        return kind == '.' ? 1 : kind == 'h' ? 2 : kind == 'd' || kind == 'U' || kind == 'I' ? 8 : 4;
    }
    template <class T> static T load(const std::byte* at) {
        T value;
        std::memcpy(&value, at, sizeof value);
        return value;
    }
    static bool is_floating(char kind) { return kind == 'f' || kind == 'h' || kind == 'd'; }
    static double number(char kind, const std::byte* at) {
        if (kind == 'f') return load<float>(at);
        if (kind == 'h') return static_cast<float>(load<half>(at));
        return load<double>(at);
    }
    static std::string text(char kind, const std::byte* at) {
        char buffer[40];
        if (is_floating(kind)) std::snprintf(buffer, sizeof buffer, "%.9g", number(kind, at));
        else if (kind == 'i') std::snprintf(buffer, sizeof buffer, "%d", load<std::int32_t>(at));
        else if (kind == 'U')
            std::snprintf(buffer, sizeof buffer, "%llu", static_cast<unsigned long long>(load<std::uint64_t>(at)));
        else if (kind == 'I')
            std::snprintf(buffer, sizeof buffer, "%lld", static_cast<long long>(load<std::int64_t>(at)));
        else std::snprintf(buffer, sizeof buffer, "%u", load<std::uint32_t>(at));
        return buffer;
    }
    /// Bit for bit but for NaNs, which are all alike, or within a tolerance.
    static bool agree(char kind, const std::byte* a, const std::byte* b, double tolerance) {
        if (std::memcmp(a, b, size_of(kind)) == 0) return true;
        if (!is_floating(kind)) return false;
        const double x = number(kind, a), y = number(kind, b);
        if (x != x && y != y) return true;
        if (tolerance == 0) return false;
        return std::fabs(x - y) <= tolerance * std::max(1.0, std::max(std::fabs(x), std::fabs(y)));
    }
};

inline Extent address_of(std::size_t index, const Extent& extent) {
    Extent address{};
    for (unsigned axis = 0; axis < 4; ++axis) {
        address[axis] = static_cast<std::uint32_t>(index % std::max(extent[axis], 1u));
        index /= std::max(extent[axis], 1u);
    }
    return address;
}

/// Where an element's scalars lie, and how far the next element is.
struct Places {
    struct Part {
        char kind;
        std::size_t offset;
    };
    std::vector<Part> parts;
    std::size_t stride = 0;
};

inline Places places_of(std::string_view scalars) {
    Places places;
    for (char kind : scalars) {
        if (kind != '.') places.parts.push_back({kind, places.stride});
        places.stride += ScalarReader::size_of(kind);
    }
    return places;
}

/// The differences between two records of elements; the first few in words.
inline void compare(const KeptStructure& a, const std::string& name_a, const KeptStructure& b,
                    const std::string& name_b, double tolerance, const std::string& where,
                    std::vector<std::string>& failures) {
    if (a.extent != b.extent || a.bytes.size() != b.bytes.size()) {
        failures.push_back(where + ": " + name_a + " is " + text_of(a.extent, a.rank) + " and " + name_b + " is " +
                           text_of(b.extent, b.rank));
        return;
    }
    const auto [parts, stride] = places_of(a.scalars);
    std::size_t differing = 0;
    if (stride == 0) return;
    for (std::size_t i = 0; i * stride < a.bytes.size(); ++i) {
        for (const Places::Part& part : parts) {
            const std::byte* x = a.bytes.data() + i * stride + part.offset;
            const std::byte* y = b.bytes.data() + i * stride + part.offset;
            if (ScalarReader::agree(part.kind, x, y, tolerance)) continue;
            if (++differing > 3) break;
            const std::string number =
                parts.size() > 1 ? " part " + std::to_string(&part - parts.data()) : std::string();
            failures.push_back(where + ": at " + text_of(address_of(i, a.extent), a.rank) + number + " " + name_a +
                               " has " + ScalarReader::text(part.kind, x) + " and " + name_b + " has " +
                               ScalarReader::text(part.kind, y));
        }
    }
    if (differing > 3) failures.push_back(where + ": and more");
}

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
    /// Translations that were checked as this test made their structures, with what was found.
    std::map<std::string, std::vector<std::string>> translations;

    void expect(bool condition, const char* place) {
        if (!condition) failures.push_back(std::string(place) + ": expect: the condition is false");
    }

    template <class T> void expect_near(const T& a, const T& b, double tolerance, const char* place) {
        if constexpr (detail::is_scalar<T>) {
            const double x = static_cast<double>(a), y = static_cast<double>(b);
            if (std::fabs(x - y) <= tolerance) return;
            char text[160];
            std::snprintf(text, sizeof text, "%s: expect_near: %.9g is not within %g of %.9g", place, x, tolerance, y);
            failures.push_back(text);
        } else {
            for (unsigned i = 0; i < detail::value_components<T>; ++i) expect_near(a[i], b[i], tolerance, place);
        }
    }

    /// Two structures or boxes of them, element by element.
    template <class A, class B>
    void expect_same(const A& a, const B& b, std::string_view scalars, const char* place, double tolerance = 0) {
        detail::compare(record("the first", a, scalars), "the first", record("the second", b, scalars), "the second",
                        tolerance, std::string(place) + ": expect_same", failures);
    }

    /// Keeps all elements of a structure, to be compared with those of another device. False where its domain is so
    /// much larger than a memory that only what it is made of can be compared.
    template <class S> bool keep(const char* name, const S& structure, std::string_view scalars) {
        if (!structure) return true;
        if constexpr (!requires { structure.row_memory(); }) {
            const Extent domain = detail::extent_of(structure.domain());
            if (detail::volume_of(domain) > largest_kept / sizeof(typename S::Element)) {
                notes.push_back(std::string(name) + ": its domain is " +
                                detail::text_of(domain, detail::Axes<typename S::Address>::count) +
                                ", so its memory and its tables were compared, not each address");
                return false;
            }
        }
        kept.push_back(record(name, structure, scalars));
        return true;
    }

    /// Keeps the elements of a buffer as they lie there.
    void keep_memory(const Commands& commands, const char* name, const Memory& memory, std::string_view scalars) {
        if (!memory) return;
        if (memory.description().kind != MemoryKind::buffer) {
            notes.push_back(std::string("not compared: ") + name + ", an image");
            return;
        }
        const Download download = commands.download(memory, 0, memory.description().bytes);
        const std::span<const std::byte> bytes = download.get();
        const auto count =
            static_cast<std::uint32_t>(bytes.size() / std::max<std::size_t>(1, detail::places_of(scalars).stride));
        kept.push_back({name, 1, {count, 1, 1, 1}, scalars, {bytes.begin(), bytes.end()}});
    }

    /// A structure of an extent that nobody asked for; nothing where the device or the structure does not take it.
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
    /// Why no extent could be tried; empty: some were.
    std::string why_nothing_was_made() const { return made_ == 0 ? refused_ : std::string(); }

    /// Checks a translation as this test made its structure.
    template <class Check> void check_as_made(const char* title, const Check& check) {
        if (translations.contains(title)) return;
        std::vector<std::string> before = std::exchange(failures, {});
        try {
            check();
            translations.emplace(title, failures);
        } catch (const Error& error) {
            notes.push_back(std::string("not checked: ") + title + ": " + error.problem());
        }
        failures = std::move(before);
    }

private:
    static constexpr std::uint64_t largest_kept = 1u << 28;  ///< bytes

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

/// Checks that boxes of a structure cover their elements exactly once: what is written to a box comes back, and nothing
/// else changes.
template <class S, class Value> void check_boxes(Test& test, const char* name, S& structure, const Value& value) {
    using A = typename S::Address;
    using T = typename S::Element;
    constexpr unsigned rank = detail::Axes<A>::count;
    const Extent domain = detail::extent_of(structure.domain());
    if (detail::volume_of(domain) == 0 || detail::volume_of(domain) > 1u << 20) return;
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
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (std::memcmp(&all[i], &out[i], sizeof(T)) == 0) continue;
        test.failures.push_back(std::string(name) + ": after writing the box " + detail::text_of(size, rank) + " at " +
                                detail::text_of(origin, rank) + ", the element at " +
                                detail::text_of(detail::address_of(i, domain), rank) + " is wrong (domain " +
                                detail::text_of(domain, rank) + ")");
        return;
    }
}

struct TestCase {
    const char* title;
    const char* place;                                  ///< file:line
    bool exact;                                         ///< all passes are exact: devices agree bit for bit
    void (*run)(Test& test, const Commands& commands);  ///< null: a translation that is checked as tests make it
    const char* why_not_alone = "";
};

namespace detail {

inline Test run_on(const Device& device, const TestCase& test) {
    Test run;
    try {
        test.run(run, device);
        device.wait();
    } catch (const std::exception& error) {
        run.failures.push_back(std::string(test.place) + ": " + error.what());
    }
    // The layer's messages list every stage and access there is: their beginning says enough.
    std::size_t messages = 0;
    for (const std::string& message : device.validation_messages()) {
        if (++messages <= 2) run.failures.push_back("validation: " + message.substr(0, 400));
    }
    if (messages > 2) run.failures.push_back("validation: " + std::to_string(messages - 2) + " more messages");
    return run;
}

/// Runs tests on all devices and prints what became of them.
class TestRunner {
public:
    explicit TestRunner(std::vector<Device> devices) : devices_(std::move(devices)) {}

    void run(const TestCase& test) {
        ++ran_;
        announce(test);
        std::vector<std::string> failures, notes;
        std::vector<Test> runs;
        for (const Device& device : devices_) {
            Test& run = runs.emplace_back(run_on(device, test));
            for (const std::string& failure : run.failures)
                failures.push_back(failure + " [" + device.properties().name + "]");
            if (const std::string why = run.why_nothing_was_made(); !why.empty())
                run.notes.push_back("not checked: " + why);
            for (const std::string& note : run.notes)
                if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
            for (const auto& [title, found] : run.translations) {
                std::vector<std::string>& all = translations_[title];
                for (const std::string& failure : found) all.push_back(failure + " [" + device.properties().name + "]");
            }
        }
        if (runs.size() == 2 && runs[0].kept.size() == runs[1].kept.size()) {
            for (std::size_t i = 0; i < runs[0].kept.size(); ++i)
                compare(runs[0].kept[i], "the host", runs[1].kept[i], devices_[1].properties().name,
                        test.exact ? 0 : inexact_tolerance, std::string(test.place) + ": " + runs[0].kept[i].name,
                        failures);
        }
        report(test, "", failures);
        for (const std::string& note : notes) std::printf("      %s\n", note.c_str());
    }

    /// After all tests: whether one of them checked this.
    void run_as_made(const TestCase& test) {
        const auto found = translations_.find(test.title);
        if (found != translations_.end()) {
            ++ran_;
            return report(test, ", as the tests made it", found->second);
        }
        ++unchecked_;
        std::printf("not checked: %s (%s): %s\n", test.title, test.place, test.why_not_alone);
    }

    int finish() const {
        std::printf("%zu tests on %s%s: %zu failed", ran_, "the host",
                    devices_.size() > 1 ? (" and " + devices_[1].properties().name).c_str() : "", failed_);
        std::printf(unchecked_ ? ", %zu not checked\n" : "\n", unchecked_);
        return failed_ == 0 ? 0 : 1;
    }

private:
    /// Leaves the test's name where `gliftc test` finds it if a signal ends the program.
    static void announce(const TestCase& test) {
        std::fflush(stdout);
        const char* path = std::getenv("GLIFT_TEST_NOW");
        if (std::FILE* file = path ? std::fopen(path, "w") : nullptr) {
            std::fprintf(file, "%s (%s)", test.title, test.place);
            std::fclose(file);
        }
    }

    void report(const TestCase& test, const char* how, const std::vector<std::string>& failures) {
        std::printf("%s  %s%s (%s)\n", failures.empty() ? "pass" : "FAIL", test.title, how, test.place);
        for (const std::string& failure : failures) std::printf("      %s\n", failure.c_str());
        failed_ += !failures.empty();
    }

    std::vector<Device> devices_;
    std::map<std::string, std::vector<std::string>> translations_;
    std::size_t ran_ = 0, failed_ = 0, unchecked_ = 0;
};

}  // namespace detail

/// `program [--filter TEXT] [--device NAME]`: runs all tests on the host device and on another one and compares what
/// they leave behind. Returns the exit code.
inline int run_tests(std::span<const TestCase> tests, int argc, char** argv) {
    std::string filter, name;
    for (int i = 1; i + 1 < argc; i += 2) (std::string_view(argv[i]) == "--filter" ? filter : name) = argv[i + 1];
    try {
        const Device host = Device::open("host");
        std::vector<Device> devices{host};
        if (name != "host") devices.push_back(Device::open(name));
        detail::TestRunner runner(std::move(devices));
        const auto is_wanted = [&](const TestCase& test) {
            return std::string_view(test.title).find(filter) != std::string_view::npos;
        };
        for (const TestCase& test : tests)
            if (test.run && is_wanted(test)) runner.run(test);
        for (const TestCase& test : tests)
            if (!test.run && is_wanted(test)) runner.run_as_made(test);
        return runner.finish();
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

}  // namespace glift
