# Writes the bytes of the file INPUT as the array declared in typeface.h into the C++ source OUTPUT.
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE ${OUTPUT}
  "#include \"ui/widgets/typeface.h\"\n\n"
  "namespace interleaf {\nnamespace {\n\nconstexpr unsigned char bytes[] = {\n${bytes}\n};\n\n}  // namespace\n\n"
  "std::span<const unsigned char> typeface() { return bytes; }\n\n}  // namespace interleaf\n")
