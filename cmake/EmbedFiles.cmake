# Writes a source file with the contents of text files as string literals:
#   cmake -D OUTPUT=page_assets.cc -D FILES="a.js;b.css" -P EmbedFiles.cmake
# A literal may have 65536 characters at most, which no file of ours reaches.
set(text "// Made by cmake/EmbedFiles.cmake.\n#include \"plugin/page/page_assets.h\"\n\n")
string(APPEND text "namespace octacut {\n\n")
string(APPEND text "std::span<const PageAsset> PageAssets() {\n")
string(APPEND text "  static constexpr PageAsset kAssets[] = {\n")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME)
  file(READ ${file} content)
  string(APPEND text "{\"${name}\", R\"octacut_asset(${content})octacut_asset\"},\n")
endforeach()
string(APPEND text "  };\n  return kAssets;\n}\n\n}  // namespace octacut\n")
file(WRITE ${OUTPUT} "${text}")
