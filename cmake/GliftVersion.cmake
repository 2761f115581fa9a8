# Sets GLIFT_VERSION to what runtime/include/glift/version.h says: MAJOR.MINOR.PATCH.

set(header ${CMAKE_CURRENT_LIST_DIR}/../runtime/include/glift/version.h)
set(GLIFT_VERSION)
foreach(part MAJOR MINOR PATCH)
    file(STRINGS ${header} line REGEX "^#define GLIFT_VERSION_${part} [0-9]+$")
    if(NOT line MATCHES "([0-9]+)$")
        message(FATAL_ERROR "${header} does not define GLIFT_VERSION_${part} as a number")
    endif()
    list(APPEND GLIFT_VERSION ${CMAKE_MATCH_1})
endforeach()
list(JOIN GLIFT_VERSION "." GLIFT_VERSION)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
