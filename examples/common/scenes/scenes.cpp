#include "scenes.h"

#include <stdexcept>

namespace scenes {

namespace {

struct Named {
    const char* name;
    Scene (*make)(float time);
};

constexpr Named all[] = {{"hairball", hairball},   {"fence", fence}, {"robot", robot},
                         {"skeletons", skeletons}, {"city", city},   {"trees", trees}};

}  // namespace

const std::vector<std::string>& names() {
    static const std::vector<std::string> list = [] {
        std::vector<std::string> made;
        for (const Named& scene : all) made.emplace_back(scene.name);
        return made;
    }();
    return list;
}

Scene make(const std::string& name, float time) {
    for (const Named& scene : all)
        if (name == scene.name) return scene.make(time);
    std::string known;
    for (const std::string& other : names()) known += (known.empty() ? "" : ", ") + other;
    throw std::runtime_error("there is no scene '" + name + "'; there are " + known);
}

}  // namespace scenes
