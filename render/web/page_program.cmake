# SPDX-License-Identifier: Apache-2.0
# Builds the students' page's program beside the others, where Emscripten is installed:
# bin/page/engine_module.js and bin/page/engine.wasm (target sline_page_program). It is made anew when
# a source of a room that it shares has changed.
find_program(SLINE_EMCMAKE emcmake)
if(NOT SLINE_EMCMAKE)
  message(STATUS "Emscripten is not installed: pages for students cannot be exported")
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
set(page_program ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/page)
add_custom_command(
  OUTPUT ${page_program}/engine_module.js ${page_program}/engine.wasm
  COMMAND ${SLINE_EMCMAKE} ${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR} -B ${page_build}
          -DCMAKE_BUILD_TYPE=Release
  COMMAND ${CMAKE_COMMAND} --build ${page_build}
  COMMAND ${CMAKE_COMMAND} -E copy ${page_build}/engine.js ${page_program}/engine_module.js
  COMMAND ${CMAKE_COMMAND} -E copy ${page_build}/engine.wasm ${page_program}/engine.wasm
  DEPENDS ${page_sources} ${others} ${CMAKE_CURRENT_LIST_DIR}/CMakeLists.txt
          ${CMAKE_CURRENT_LIST_DIR}/rooms.cmake
  COMMENT "Building the program of the students' page"
  VERBATIM)
add_custom_target(sline_page_program ALL
  DEPENDS ${page_program}/engine_module.js ${page_program}/engine.wasm)
