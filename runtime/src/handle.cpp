// Errors for empty handles.
#include <glift/handle.h>

#include <glift/error.h>

#include <string>
#include <string_view>

namespace glift::detail {

namespace {

struct HandleKind {
    std::string_view name;
    const char* remedy;
};

constexpr HandleKind kinds[] = {
    {"Device", "open one: glift::Device::open()"},
    {"Memory", "allocate it: Device::allocate or Commands::allocate"},
    {"Commands", "make them from a device: glift::Commands(device)"},
    {"Recording", "record it first: Device::record"},
    {"Download", "ask for it first: Commands::download"},
    {"Timestamp", "ask for it first: Commands::timestamp"},
};

}  // namespace

void throw_empty_handle(const char* call) {
    const std::string_view text = call;
    const std::string_view name = text.substr(0, text.find_first_of(":,"));
    for (const HandleKind& kind : kinds) {
        if (kind.name != name) continue;
        throw Error(ErrorCode::wrong_argument, "an empty " + std::string(name) + " handle was used", call,
                    "it was default-constructed, or moved from", kind.remedy);
    }
    throw Error(ErrorCode::wrong_argument, "an empty handle was used", call,
                "it was default-constructed, or moved from", "use the handle that it was moved to");
}

}  // namespace glift::detail
