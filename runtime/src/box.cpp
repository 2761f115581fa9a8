// Errors of structures and ranges: boxes, slices and addresses out of bounds, empty structures, numbers that do not
// fit. They are not inline, so that generated sources need not compile the code that makes the messages.
#include "text.h"

#include <glift/box.h>
#include <glift/log.h>
#include <glift/mapped.h>
#include <glift/resident.h>

#include <new>
#include <stdexcept>
#include <string>

namespace glift::detail {

std::string text_of(const Extent& extent, unsigned rank) {
    std::string text = "{";
    for (unsigned i = 0; i < rank; ++i) text += (i ? ", " : "") + std::to_string(extent[i]);
    return text + "}";
}

void throw_outside(const std::string& where, const Box& box) {
    throw Error(ErrorCode::wrong_argument, std::string("a box of ") + box.name + " lies outside its domain", where,
                box.name + (" starts at " + text_of(box.origin, box.rank)) + " and is " + text_of(box.size, box.rank) +
                    " large, the domain is " + text_of(box.domain, box.rank),
                "pass a box inside the domain");
}

void throw_outside(const char* type, const char* operation, const Box& box) {
    throw_outside(std::string(type) + "::" + operation, box);
}

void throw_outside_range(const char* name, const Box& box) {
    throw Error(ErrorCode::wrong_argument,
                std::string("a box lies outside the range of ") + name + " that it is taken from",
                std::string(name) + "::range",
                "it starts at " + text_of(box.origin, box.rank) + " and is " + text_of(box.size, box.rank) +
                    " large, the range is " + text_of(box.domain, box.rank),
                "pass a box inside the range; its addresses count from the range's origin");
}

void throw_slice(const char* place, unsigned rank, const Extent& first, const Extent& last, const Extent& whole) {
    bool ends_first = false;
    for (unsigned axis = 0; axis < rank; ++axis) ends_first = ends_first || last[axis] < first[axis];
    throw Error(ErrorCode::wrong_argument,
                ends_first ? "a slice ends before it begins" : "a slice lies outside what it is taken from", place,
                "it goes from " + text_of(first, rank) + " to before " + text_of(last, rank) +
                    ", and there are elements from 0 to before " + text_of(whole, rank),
                "slice as a[first .. last], with first <= last and last no larger than the extent");
}

void throw_empty_structure(const char* type, const char* operation) {
    throw Error(ErrorCode::wrong_argument, std::string("an empty ") + type + " was used",
                std::string(type) + "::" + operation, "it was default-constructed, or moved from",
                std::string("make it with a device first: ") + type + "(device, ...)");
}

void throw_unfitted(std::uint64_t value, const char* what) {
    throw Error(ErrorCode::too_large, "a number that a uint holds passes 2^32 - 1", what,
                "it is " + std::to_string(value), "make the structure smaller");
}

void throw_count(const char* type, std::size_t given, const Extent& size, unsigned rank) {
    throw Error(ErrorCode::wrong_argument, "the values do not fill the box", std::string(type) + "::write",
                std::to_string(given) + " values for a box of " + text_of(size, rank), "pass one value an element");
}

void throw_not_searched(const char* type, std::uint64_t elements) {
    throw Error(ErrorCode::too_large, "a domain in which every address would have to be looked at",
                std::string(type) + "::read_resident", std::to_string(elements) + " addresses",
                "read a box, or a structure with blocks that say what is there: std.paged.ListedPages");
}

void throw_outside_mapped(const Box& box) {
    throw Error(ErrorCode::wrong_argument, std::string("an address outside a mapped box of ") + box.name,
                std::string(box.name) + "::map, Mapped::operator[]",
                "address " + text_of(box.origin, box.rank) + ", the box is " + text_of(box.domain, box.rank),
                "addresses count from the box's origin: stay below Mapped::size()");
}

void throw_unmapped(const char* type, const char* operation) {
    throw Error(ErrorCode::wrong_argument, std::string("a box of ") + type + " is no longer mapped",
                std::string("Mapped::") + operation, "it was unmapped, or moved from", "map it again");
}

namespace {

void log_unwritten(const char* type, const std::exception& error) noexcept {
    try {
        log(std::string("the values of a mapped ") + type + " were not written: " + error.what());
    } catch (...) {
        // The log itself failed, and a destructor cannot throw.
    }
}

}  // namespace

void write_back(const char* type, void (*write)(void* mapped), void* mapped) noexcept {
    try {
        write(mapped);
    } catch (const std::exception& error) {
        log_unwritten(type, error);
    }
}

void make_values(const char* type, unsigned rank, const Extent& size, std::size_t element_bytes,
                 const ValueList& list) {
    const std::uint64_t elements = volume_of(size);
    const auto refuse = [&] {
        throw Error(ErrorCode::out_of_memory, "the host has no memory left for the values of a box",
                    std::string(type) + "::read, or ::map",
                    text_of(size, rank) + " elements, " + size_text(saturated_product(elements, element_bytes)),
                    "read smaller boxes, or only the resident elements (read_resident)");
    };
    try {
        list.resize(list.values, elements);
    } catch (const std::bad_alloc&) {
        refuse();
    } catch (const std::length_error&) {
        refuse();
    }
}

void throw_other_part(const char* name) {
    throw Error(ErrorCode::wrong_argument, "a part was made with other arguments than the structure would make it with",
                name, {}, "make it with the arguments that the structure's declaration gives it");
}

}  // namespace glift::detail
