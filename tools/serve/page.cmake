# The page's files become part of the program: what is not in this list does not exist for the server.
# The assembler takes them as they are (.incbin), which takes no time to compile. The hash of each stands in
# the source, since caches of compilers look at that alone.

find_file(THREE_MODULE three.module.js PATHS /usr/share/javascript/three REQUIRED)   # libjs-three
get_filename_component(three_folder ${THREE_MODULE} DIRECTORY)
set(three_licence /usr/share/doc/libjs-three/copyright)

set(page_rows)      # path in the URL, file
file(GLOB page_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/page/*)
foreach(file ${page_sources})
    get_filename_component(name ${file} NAME)
    list(APPEND page_rows "/${name}" ${file})
endforeach()
list(APPEND page_rows
     /three/build/three.module.js ${THREE_MODULE}
     /three/examples/jsm/controls/OrbitControls.js
     ${three_folder}/examples/jsm/controls/OrbitControls.js)
if(EXISTS ${three_licence})
    list(APPEND page_rows /three/licence.txt ${three_licence})
endif()

set(type_html "text/html; charset=utf-8")
set(type_js "text/javascript; charset=utf-8")
set(type_css "text/css; charset=utf-8")
set(type_svg "image/svg+xml")
set(type_txt "text/plain; charset=utf-8")
set(symbols)
set(declared)
set(table)
set(used_files)
set(index 0)
while(page_rows)
    list(POP_FRONT page_rows url file)
    string(REGEX REPLACE "^.*[.]" "" extension ${url})
    file(SHA256 ${file} hash)
    string(APPEND symbols
           "asm(\".section .rodata\\n.global page_${index}\\npage_${index}: /* ${hash} */\\n.incbin \\\"${file}\\\"\\n\"\n"
           "    \".global page_${index}_end\\npage_${index}_end:\\n.byte 0\\n.previous\\n\");\n")
    string(APPEND declared "extern \"C\" const char page_${index}[], page_${index}_end[];\n")
    string(APPEND table
           "        row(\"${url}\", \"${type_${extension}}\", page_${index}, page_${index}_end),\n")
    list(APPEND used_files ${file})
    math(EXPR index "${index} + 1")
endwhile()

set(generated ${CMAKE_BINARY_DIR}/page_files.cpp)
file(CONFIGURE OUTPUT ${generated} @ONLY CONTENT [=[
#include "tools/serve/page_file.hpp"

@symbols@@declared@
namespace specula {
namespace {

PageFile row(std::string_view path, std::string_view type, const char* begin, const char* end) {
    return {path, type, {begin, static_cast<std::size_t>(end - begin)}};
}

}  // namespace

std::span<const PageFile> page_files() {
    static const PageFile files[] = {
@table@    };
    return files;
}

}  // namespace specula
]=])
set_source_files_properties(${generated} PROPERTIES OBJECT_DEPENDS "${used_files}")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${used_files})
add_library(specula_page STATIC ${generated})
target_link_libraries(specula_page PUBLIC specula_options)
set_target_properties(specula_page PROPERTIES UNITY_BUILD OFF)
