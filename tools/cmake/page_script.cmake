# The script of live pages: the modules of src/page/web one after the other, without their imports and exports, because a
# page from the disk and one in a sandbox may not load modules. So no two modules give one name to different things.
file(GLOB page_modules CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/page/web/*.js)
list(REMOVE_ITEM page_modules ${PROJECT_SOURCE_DIR}/src/page/web/main.js)
list(APPEND page_modules ${PROJECT_SOURCE_DIR}/src/page/web/main.js)  # it starts the others
set(page_script "\"use strict\";\n(() => {\n")
foreach(module ${page_modules})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${module})
    file(READ ${module} text)
    string(REGEX REPLACE "(^|\n)import [^;]*;" "\\1" text "${text}")
    string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
    string(APPEND page_script "${text}")
endforeach()
string(APPEND page_script "})();\n")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/live.js CONTENT "${page_script}" @ONLY)
glibra_embed(glibra_page live_page ${PROJECT_BINARY_DIR}/generated/live.js ${PROJECT_SOURCE_DIR}/src/page/web/live.css
             ${PROJECT_SOURCE_DIR}/src/page/web/page.html)
