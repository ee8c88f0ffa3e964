// The program: one command line in, one exit code out.
#include <cstdio>

int main() {
    std::puts("pxm " PXM_VERSION);
    return 0;
}
