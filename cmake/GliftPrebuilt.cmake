# Makes the target glift::gliftc from GLIFT_GLIFTC, a gliftc of this version that is built already. Like every gliftc,
# it finds the standard library and the runtime's headers relative to itself.

execute_process(COMMAND ${GLIFT_GLIFTC} --version OUTPUT_VARIABLE found RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE)
if(failed)
    message(FATAL_ERROR "GLIFT_GLIFTC: ${GLIFT_GLIFTC} does not run: ${failed}")
endif()
if(NOT found STREQUAL "gliftc ${PROJECT_VERSION}")
    message(FATAL_ERROR "GLIFT_GLIFTC: ${GLIFT_GLIFTC} is ${found}, and what it generates is not for the runtime of ${PROJECT_VERSION}. Name a gliftc of that version.")
endif()
add_executable(glift::gliftc IMPORTED GLOBAL)
set_target_properties(glift::gliftc PROPERTIES IMPORTED_LOCATION ${GLIFT_GLIFTC})
