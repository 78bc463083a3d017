// The start of every test program.

#include "tests/support/test_class.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace carina::test
{
namespace
{

struct Named {
    std::string_view name;
    TestEntry::Run run;
};

std::vector<Named>& entries()
{
    static std::vector<Named> all;
    return all;
}

std::string_view nameIn(std::string_view path)
{
    std::string_view name = path.substr(path.rfind('/') + 1);
    name = name.substr(0, name.rfind('.'));
    return name.starts_with("tst_") ? name.substr(4) : name;
}

} // namespace

TestEntry::TestEntry(std::string_view path, Run run)
{
    const std::string_view name = nameIn(path);
    if (std::ranges::find(entries(), name, &Named::name) != entries().end()) {
        std::fprintf(stderr, "two test classes are called %s\n", std::string{name}.c_str());
        std::abort();
    }
    entries().push_back({name, run});
}

int TestEntry::runNamed(int argc, char** argv)
{
    const std::string_view wanted = argc > 1 ? argv[1] : "";
    const auto entry = std::ranges::find(entries(), wanted, &Named::name);
    if (entry == entries().end()) {
        std::fprintf(stderr, "%s TEST [ARGUMENTS OF QT TEST]. It has the tests:\n", argv[0]);
        std::ranges::sort(entries(), {}, &Named::name);
        for (const Named& each : entries())
            std::fprintf(stderr, "  %s\n", std::string{each.name}.c_str());
        return 2;
    }
    argv[1] = argv[0];
    --argc;
    return entry->run(argc, argv + 1);
}

} // namespace carina::test

int main(int argc, char** argv) { return carina::test::TestEntry::runNamed(argc, argv); }
