#include "cli/cli.h"

int main(int argc, char** argv) {
    return wrinkle::cli::run_cli(argc, argv);
}
