// Nothing of its own: it makes CMake build the precompiled headers the tests share.
int main() {
  return 0;
}
