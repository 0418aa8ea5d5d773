// Represents a program that has its shaders built in.
#include <cstdio>

int main() {
    if (std::FILE* file = std::fopen(SHADER, "r")) return std::fclose(file);
    return 1;
}
