# glift_embed_shader(TARGET FILE): compiles a GLSL shader at build time into a header NAME.h with
# `const uint32_t NAME[]`, on TARGET's include path. For shaders written by hand; generated code embeds its own.
function(glift_embed_shader target file)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE source)
    cmake_path(GET source STEM name)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/shaders/${target})
    set(header ${folder}/${name}.h)
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${header}
        COMMAND ${GLSLANG_VALIDATOR} --quiet -V --target-env vulkan1.3 --vn ${name} -o ${header} ${source}
        DEPENDS ${source} VERBATIM)
    target_sources(${target} PRIVATE ${header})
    target_include_directories(${target} PRIVATE ${folder})
endfunction()
