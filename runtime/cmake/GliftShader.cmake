# glift_embed_shader(TARGET FILE [NAME name] [DEFINE macro]): compiles a GLSL shader at build time into a header NAME.h with
# `const uint32_t NAME[]`, on TARGET's include path; the name is the file's if none is given. For shaders written by hand;
# generated code embeds its own.
function(glift_embed_shader target file)
    cmake_parse_arguments(PARSE_ARGV 2 shader "" "NAME;DEFINE" "")
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE source)
    cmake_path(GET source STEM name)
    set(define)
    if(shader_NAME)
        set(name ${shader_NAME})
    endif()
    if(shader_DEFINE)
        set(define -D${shader_DEFINE})
    endif()
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/shaders/${target})
    set(header ${folder}/${name}.h)
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${header}
        COMMAND ${GLSLANG_VALIDATOR} --quiet -V --target-env vulkan1.3 ${define} --vn ${name} -o ${header} ${source}
        DEPENDS ${source} VERBATIM)
    target_sources(${target} PRIVATE ${header})
    target_include_directories(${target} PRIVATE ${folder})
endfunction()
