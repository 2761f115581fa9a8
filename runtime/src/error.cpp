#include <glift/error.h>

namespace glift {

Error::Error(ErrorCode code, std::string problem, std::string where, std::string why, std::string remedy)
    : code_(code), problem_(std::move(problem)), where_(std::move(where)), why_(std::move(why)),
      remedy_(std::move(remedy)), text_(problem_) {
    if (!where_.empty()) text_ += "\n  where: " + where_;
    if (!why_.empty()) text_ += "\n  why: " + why_;
    if (!remedy_.empty()) text_ += "\n  remedy: " + remedy_;
}

}  // namespace glift
