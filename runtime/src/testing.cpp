// The code of test programs that does not depend on the types of their structures.
#include "test_watchdog.h"

#include <glift/inspected_values.h>
#include <glift/testing.h>
#include <glift/translation_checks.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <utility>

namespace glift {

namespace {

using detail::address_of;
using detail::text_of;

struct ScalarReader {
    static std::size_t size_of(char kind) {
        return kind == '.' ? 1 : kind == 'h' ? 2 : kind == 'd' || kind == 'U' || kind == 'I' ? 8 : 4;
    }
    template <class T> static T load(const std::byte* at) {
        T value;
        std::memcpy(&value, at, sizeof value);
        return value;
    }
    static bool is_floating(char kind) { return kind == 'f' || kind == 'n' || kind == 'h' || kind == 'd'; }
    static double number(char kind, const std::byte* at) {
        if (kind == 'f' || kind == 'n') return load<float>(at);
        if (kind == 'h') return static_cast<float>(load<half>(at));
        return load<double>(at);
    }
    static std::string text(char kind, const std::byte* at) {
        if (is_floating(kind)) return detail::number_text(number(kind, at), 9);
        if (kind == 'i') return std::to_string(load<std::int32_t>(at));
        if (kind == 'U') return std::to_string(load<std::uint64_t>(at));
        if (kind == 'I') return std::to_string(load<std::int64_t>(at));
        return std::to_string(load<std::uint32_t>(at));
    }
    /// Whether two scalars have the same bits, are floats that are both NaN, or, unless the tolerance is 0, are floats
    /// that differ by no more than the tolerance times the largest of 1 and their magnitudes (those that are drawn,
    /// kind n: by no more than byte_tolerance).
    static bool agree(char kind, const std::byte* a, const std::byte* b, double tolerance) {
        if (std::memcmp(a, b, size_of(kind)) == 0) return true;
        if (!is_floating(kind)) return false;
        const double x = number(kind, a), y = number(kind, b);
        if (x != x && y != y) return true;
        if (tolerance == 0) return false;
        if (kind == 'n') return std::fabs(x - y) <= byte_tolerance;
        return std::fabs(x - y) <= tolerance * std::max(1.0, std::max(std::fabs(x), std::fabs(y)));
    }
};

/// Where an element's scalars lie, and how many bytes it is from one element to the next.
struct Places {
    struct Part {
        char kind;
        std::size_t offset;
    };
    std::vector<Part> parts;
    std::size_t stride = 0;
};

Places places_of(std::string_view scalars) {
    Places places;
    for (char kind : scalars) {
        if (kind != '.') places.parts.push_back({kind, places.stride});
        places.stride += ScalarReader::size_of(kind);
    }
    return places;
}

/// Adds those texts that are not there yet.
void add_new(std::vector<std::string>& texts, const std::vector<std::string>& more) {
    for (const std::string& text : more)
        if (std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
}

Test run_on(const Device& device, const TestCase& test) {
    Test run;
    device.on_message([&run](const Message& message) { run.messages.push_back(message); });
    try {
        test.run(run, device);
        device.wait();
    } catch (const Error& error) {
        // What failed is among the messages.
        if (error.code() != ErrorCode::assertion_failed)
            run.failures.push_back(std::string(test.place) + ": " + error.what());
    } catch (const std::exception& error) {
        run.failures.push_back(std::string(test.place) + ": " + error.what());
    }
    device.on_message({});
    // A message of the validation layer may list every stage and access that there is: its beginning says enough.
    std::size_t messages = 0;
    for (const std::string& message : device.validation_messages()) {
        if (++messages <= 2) run.failures.push_back("validation: " + message.substr(0, 400));
    }
    if (messages > 2) run.failures.push_back("validation: " + std::to_string(messages - 2) + " more messages");
    return run;
}

/// Runs tests on all devices and prints their results.
class TestRunner {
public:
    TestRunner(std::vector<Device> devices, std::chrono::seconds most)
        : devices_(std::move(devices)), watchdog_(most) {}

    void run(const TestCase& test) {
        ++ran_;
        const detail::TestWatchdog::Watch watch(watchdog_);
        Findings findings;
        auto& [failures, notes, printed] = findings;
        std::vector<Test> runs;
        for (const Device& device : devices_) {
            announce(test, device);
            Test& run = runs.emplace_back(run_on(device, test));
            for (const std::string& failure : run.failures)
                failures.push_back(failure + " [" + device.properties().name + "]");
            for (const Message& message : run.messages) {
                if (message.kind == Message::Kind::assertion) add_new(failures, {to_text(message)});
                if (message.kind == Message::Kind::lost)
                    add_new(notes, {to_text(message) + " [" + device.properties().name + "]"});
            }
            if (const std::string why = run.why_nothing_was_made(); !why.empty())
                run.notes.push_back("not checked: " + why);
            unchecked_.merge(run.unchecked);
            add_new(notes, run.notes);
            for (const auto& [title, found] : run.translations) {
                auto& [all_failures, all_notes, none_printed] = translations_[title];
                for (const std::string& failure : found.failures)
                    add_new(all_failures, {failure + " [" + device.properties().name + "]"});
                add_new(all_notes, found.notes);
            }
        }
        if (runs.size() == 2 && runs[0].kept.size() == runs[1].kept.size()) {
            for (std::size_t i = 0; i < runs[0].kept.size(); ++i)
                detail::compare(runs[0].kept[i], "the host", runs[1].kept[i], devices_[1].properties().name,
                                test.tolerance, std::string(test.place) + ": " + runs[0].kept[i].name, failures);
        }
        if (runs.size() == 2)
            detail::compare_messages(runs[0].messages, "the host", runs[1].messages, devices_[1].properties().name,
                                     test.tolerance, test.place, failures);
        for (const Message& message : runs[0].messages)
            if (message.kind == Message::Kind::print) printed.push_back(to_text(message));
        report(test, "", findings);
    }

    /// For a translator that is checked, if at all, with structures that other tests make: reports what was found, or
    /// why it was not checked. Called after all these tests have run.
    void run_as_made(const TestCase& test) {
        const auto found = translations_.find(test.title);
        const auto refused = unchecked_.find(test.title);
        if (found != translations_.end()) {
            ++ran_;
            if (refused != unchecked_.end()) found->second.notes.push_back("not checked of some: " + refused->second);
            return report(test, ", as the tests made it", found->second);
        }
        ++number_unchecked_;
        std::printf("not checked: %s (%s): %s\n", test.title, test.place,
                    refused == unchecked_.end() ? test.why_not_alone : refused->second.c_str());
    }

    int finish() const {
        std::printf("%zu test%s on %s%s: %zu failed", ran_, ran_ == 1 ? "" : "s", "the host",
                    devices_.size() > 1 ? (" and " + devices_[1].properties().name).c_str() : "", failed_);
        std::printf(number_unchecked_ ? ", %zu not checked\n" : "\n", number_unchecked_);
        const bool checked_nothing = ran_ == 0 && number_unchecked_ != 0;
        return failed_ == 0 && !checked_nothing ? 0 : 1;
    }

private:
    /// Leaves the names of the test and of the device where the watchdog finds them, and `gliftc test` if a signal ends
    /// the program.
    void announce(const TestCase& test, const Device& device) {
        std::fflush(stdout);
        const std::string title = std::string(test.title) + " (" + test.place + ")";
        watchdog_.name(title, device.properties().name);
        const char* path = std::getenv("GLIFT_TEST_NOW");
        if (std::FILE* file = path ? std::fopen(path, "w") : nullptr) {
            std::fprintf(file, "%s [%s]", title.c_str(), device.properties().name.c_str());
            std::fclose(file);
        }
    }

    void report(const TestCase& test, const char* how, const Findings& findings) {
        std::printf("%s  %s%s (%s)\n", findings.failures.empty() ? "pass" : "FAIL", test.title, how, test.place);
        constexpr std::size_t most_shown = 100;
        for (std::size_t i = 0; i < std::min(findings.printed.size(), most_shown); ++i)
            std::printf("      %s\n", findings.printed[i].c_str());
        if (findings.printed.size() > most_shown)
            std::printf("      … and %zu messages more\n", findings.printed.size() - most_shown);
        for (const std::string& failure : findings.failures) {
            std::istringstream lines(failure);
            for (std::string line; std::getline(lines, line);) std::printf("      %s\n", line.c_str());
        }
        for (const std::string& note : findings.notes) std::printf("      %s\n", note.c_str());
        failed_ += !findings.failures.empty();
    }

    std::vector<Device> devices_;
    detail::TestWatchdog watchdog_;
    std::map<std::string, Findings> translations_;
    std::map<std::string, std::string> unchecked_;  ///< why, by the title of the check
    std::size_t ran_ = 0, failed_ = 0, number_unchecked_ = 0;
};

}  // namespace

namespace detail {

std::string number_text(bool value) { return value ? "true" : "false"; }
std::string number_text(float value) { return number_text(double{value}, 9); }
std::string number_text(double value) { return number_text(value, 17); }
std::string number_text(std::int64_t value) { return std::to_string(value); }
std::string number_text(std::uint64_t value) { return std::to_string(value); }

Extent address_of(std::size_t index, const Extent& extent) {
    Extent address{};
    for (unsigned axis = 0; axis < 4; ++axis) {
        address[axis] = static_cast<std::uint32_t>(index % std::max(extent[axis], 1u));
        index /= std::max(extent[axis], 1u);
    }
    return address;
}

void compare(const KeptStructure& a, const std::string& name_a, const KeptStructure& b, const std::string& name_b,
             double tolerance, const std::string& where, std::vector<std::string>& failures) {
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

namespace {

/// Whether two texts are equal but for numbers that differ by no more than the tolerance times the largest of 1 and
/// their magnitudes.
bool texts_agree(const char* a, const char* b, double tolerance) {
    while (*a != 0 && *b != 0) {
        char *end_a = nullptr, *end_b = nullptr;
        const double x = std::strtod(a, &end_a), y = std::strtod(b, &end_b);
        const bool are_numbers = end_a != a && end_b != b && std::isfinite(x) && std::isfinite(y);
        if (are_numbers) {
            if (!(std::fabs(x - y) <= tolerance * std::max(1.0, std::max(std::fabs(x), std::fabs(y))))) return false;
            a = end_a;
            b = end_b;
        } else if (*a++ != *b++) {
            return false;
        }
    }
    return *a == *b;
}

bool messages_agree(const Message& a, const Message& b, double tolerance) {
    if (a == b) return true;
    Message with_text = b;
    with_text.text = a.text;
    return tolerance != 0 && a == with_text && texts_agree(a.text.c_str(), b.text.c_str(), tolerance);
}

bool were_lost(const std::vector<Message>& messages) {
    return std::ranges::any_of(messages, [](const Message& one) { return one.kind == Message::Kind::lost; });
}

}  // namespace

void compare_messages(const std::vector<Message>& a, const std::string& name_a, const std::vector<Message>& b,
                      const std::string& name_b, double tolerance, const std::string& where,
                      std::vector<std::string>& failures) {
    if (were_lost(a) || were_lost(b)) return;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (messages_agree(a[i], b[i], tolerance)) continue;
        if (++differing > 3) break;
        failures.push_back(where + ": message " + std::to_string(i + 1) + ": " + name_a + " printed '" + to_text(a[i]) +
                           "' and " + name_b + " '" + to_text(b[i]) + "'");
    }
    if (differing > 3) failures.push_back(where + ": and more");
    if (a.size() != b.size())
        failures.push_back(where + ": " + name_a + " printed " + std::to_string(a.size()) + " messages and " + name_b +
                           " " + std::to_string(b.size()));
}

void fail_box(Test& test, const char* name, unsigned rank, const Extent& size, const Extent& origin,
              const Extent& wrong, const Extent& domain) {
    test.failures.push_back(std::string(name) + ": after writing the box " + text_of(size, rank) + " at " +
                            text_of(origin, rank) + ", the element at " + text_of(wrong, rank) + " is wrong (domain " +
                            text_of(domain, rank) + ")");
}

bool is_one_to_one(Test& test, const TranslatorText& text, Mapping mapping, std::vector<Translated>& all) {
    std::ranges::sort(all, {}, [](const Translated& one) { return std::pair(one.physical, one.address); });
    bool apart = true;
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (all[i].physical != all[i - 1].physical || all[i].address == all[i - 1].address) continue;
        const bool is_first = std::exchange(apart, false);
        if (mapping == Mapping::many_to_one || test.failures.size() > 3) break;
        const std::string found = text_of(all[i - 1].address, text.rank) + " and " +
                                  text_of(all[i].address, text.rank) + " both map to " +
                                  text_of(all[i].physical, text.physical_rank) + " (domain " + text.domain + ")";
        if (mapping == Mapping::by_tables) {
            test.notes.push_back(text.name + ": " + found +
                                 "; whether it may is not checked: it reads tables, and is declared neither "
                                 "@one_to_one nor @many_to_one");
            break;
        }
        test.failures.push_back(text.name + ": not one-to-one: " + found);
        if (mapping == Mapping::undeclared && is_first)
            test.failures.back() += "; if it is meant to be so, declare the translator @many_to_one";
    }
    return apart;
}

bool is_within(const Extent& limit, const Extent& address) { return std::ranges::equal(address, limit, std::less()); }

bool is_inside(Test& test, const TranslatorText& text, const Extent& memory, const std::vector<Translated>& all) {
    bool inside = true;
    for (const Translated& one : all) {
        if (is_within(memory, one.physical)) continue;
        inside = false;
        if (test.failures.size() > 3) break;
        test.failures.push_back(text.name + ": " + text_of(one.address, text.rank) + " maps to " +
                                text_of(one.physical, text.physical_rank) + ", outside of the memory, which is " +
                                text_of(memory, text.physical_rank) + " (domain " + text.domain + ")");
    }
    return inside;
}

void fail_inverse(Test& test, const TranslatorText& text, const Extent& address, const Extent& back) {
    test.failures.push_back(text.name + ": invert(translate(" + text_of(address, text.rank) + ")) is " +
                            text_of(back, text.rank) + " (domain " + text.domain + ")");
}

}  // namespace detail

void Test::expect(bool condition, const char* place, const char* text) {
    if (!condition) failures.push_back(std::string(place) + ": expect: '" + text + "' is false");
}

void Test::expect_numbers_near(double a, double b, double tolerance, const char* place) {
    if (std::fabs(a - b) <= tolerance) return;
    const auto text = [](double x) { return detail::number_text(x, 9); };
    failures.push_back(std::string(place) + ": expect_near: " + text(a) + " is not within " + text(tolerance) + " of " +
                       text(b));
}

void Test::check_as_made(const char* title, const char* path, void (*check)(const void* body), const void* body) {
    Findings before{std::exchange(failures, {}), std::exchange(notes, {})};
    try {
        check(body);
        Findings& found = translations[title];
        if (const std::string member = path; member.find('.') != std::string::npos)
            for (std::string& failure : failures) failure += "; it is " + member;
        add_new(found.failures, failures);
        add_new(found.notes, notes);
    } catch (const Error& error) {
        unchecked.emplace(title, error.problem());
    }
    failures = std::move(before.failures);
    notes = std::move(before.notes);
}

void Test::keep_memory(const Commands& commands, const char* name, const Memory& memory, std::string_view scalars) {
    if (!memory) return;
    if (memory.description().kind != MemoryKind::buffer) {
        notes.push_back(std::string("not compared: ") + name + ", an image");
        return;
    }
    if (memory.description().bytes > largest_compared) {
        notes.push_back(std::string("not compared: ") + name + ", which has more than 4 GiB");
        return;
    }
    try {
        const Download download = commands.download(memory, 0, memory.description().bytes);
        const std::span<const std::byte> bytes = download.get();
        const std::size_t stride = std::max<std::size_t>(1, places_of(scalars).stride);
        const auto count = static_cast<std::uint32_t>(bytes.size() / stride);
        kept.push_back({name, 1, {count, 1, 1, 1}, scalars, {bytes.begin(), bytes.end()}});
    } catch (const Error& error) {
        note_given_up(name, error);
    }
}

void Test::note_given_up(const char* name, const Error& error) {
    if (error.code() != ErrorCode::given_up) throw error;
    notes.push_back(std::string("not compared: ") + name + ", over memory that its container has given up");
}

int run_tests(std::span<const TestCase> tests, int argc, char** argv) {
    std::string filter, name, seconds = "0";
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string_view option = argv[i];
        (option == "--filter" ? filter : option == "--timeout" ? seconds : name) = argv[i + 1];
    }
    try {
        const Device host = Device::open("host");
        std::vector<Device> devices{host};
        if (const Device other = Device::open(name); !other.is_host()) devices.push_back(other);
        TestRunner runner(std::move(devices), std::chrono::seconds(std::atol(seconds.c_str())));
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
