# SPDX-License-Identifier: Apache-2.0
# The modules of the students' page become one script, where esbuild is installed.
find_program(SLINE_ESBUILD esbuild)

# The bundler names modules by their paths from here, so that a page does not tell where it was built.
set(SLINE_PAGE_MODULES ${PROJECT_BINARY_DIR}/page_modules)
file(MAKE_DIRECTORY ${SLINE_PAGE_MODULES})
foreach(folder render resources tests)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${SLINE_PAGE_MODULES}/${folder} SYMBOLIC)
endforeach()

# sline_page_bundle(FOLDER ENTRY MODULE...) writes page.html, page.css and page.js into FOLDER. In page.js
# are the module ENTRY, named from the source tree's top, and all that it imports; the MODULEs are files
# outside of resources/page that it does. `engine_module` is what Emscripten makes.
function(sline_page_bundle folder entry)
  file(GLOB parts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/resources/page/*.js)
  # Its `strict` is what makes the script strict.
  set(settings ${PROJECT_SOURCE_DIR}/resources/page/tsconfig.json)
  set(html ${PROJECT_SOURCE_DIR}/resources/page/page.html)
  set(style ${PROJECT_SOURCE_DIR}/resources/page/page.css)
  add_custom_command(
    OUTPUT ${folder}/page.html ${folder}/page.css ${folder}/page.js
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ${SLINE_ESBUILD} ${entry} --bundle --format=iife --target=es2021 --charset=utf8
            --tsconfig=${settings}
            --preserve-symlinks --alias:engine_module=./engine_module.mjs --log-level=warning
            "--banner:js=// SPDX-License-Identifier: Apache-2.0" --outfile=${folder}/page.js
    COMMAND ${CMAKE_COMMAND} -E copy ${html} ${style} ${folder}
    WORKING_DIRECTORY ${SLINE_PAGE_MODULES}
    DEPENDS ${parts} ${PROJECT_SOURCE_DIR}/${entry} ${settings} ${html} ${style} ${ARGN}
    COMMENT "Bundling ${entry}"
    VERBATIM)
endfunction()
