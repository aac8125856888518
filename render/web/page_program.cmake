# SPDX-License-Identifier: Apache-2.0
# Builds what all students' pages share beside the programs, where Emscripten and esbuild are installed:
# bin/page with engine.wasm, page.html, page.css and page.js (target sline_page_program). The program is
# made anew when a source of a room that it shares has changed.
find_program(SLINE_EMCMAKE emcmake)
if(NOT SLINE_EMCMAKE OR NOT SLINE_ESBUILD)
  message(STATUS "Emscripten or esbuild is not installed: pages for students cannot be exported")
  return()
endif()
include(${CMAKE_CURRENT_LIST_DIR}/rooms.cmake)
set(page_sources "")
foreach(room ${SLINE_PAGE_ROOMS})
  file(GLOB_RECURSE own CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${room}/*.cpp
    ${PROJECT_SOURCE_DIR}/${room}/*.h ${PROJECT_SOURCE_DIR}/${room}/*.glsl)
  list(APPEND page_sources ${own})
endforeach()
file(GLOB others CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/resources/shaders/*.glsl
  ${PROJECT_SOURCE_DIR}/resources/anatomy/*.tsv)
set(page_build ${PROJECT_BINARY_DIR}/page)
set(page_folder ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/page)
add_custom_command(
  OUTPUT ${SLINE_PAGE_MODULES}/engine_module.mjs ${page_folder}/engine.wasm
  COMMAND ${SLINE_EMCMAKE} ${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR} -B ${page_build}
          -DCMAKE_BUILD_TYPE=Release
  COMMAND ${CMAKE_COMMAND} --build ${page_build}
  COMMAND ${CMAKE_COMMAND} -E copy ${page_build}/engine.mjs ${SLINE_PAGE_MODULES}/engine_module.mjs
  COMMAND ${CMAKE_COMMAND} -E copy ${page_build}/engine.wasm ${page_folder}/engine.wasm
  DEPENDS ${page_sources} ${others} ${CMAKE_CURRENT_LIST_DIR}/CMakeLists.txt
          ${CMAKE_CURRENT_LIST_DIR}/rooms.cmake
  COMMENT "Building the program of the students' page"
  VERBATIM)
file(GLOB engine_parts CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.js)
sline_page_bundle(${page_folder} resources/page/start.js ${engine_parts}
  ${SLINE_PAGE_MODULES}/engine_module.mjs)
add_custom_target(sline_page_program ALL DEPENDS ${page_folder}/engine.wasm ${page_folder}/page.js)
