#include "engine/core/expects.h"

#include <cstdio>
#include <cstdlib>

namespace carina::detail
{

void expectationFailed(const char* condition, const char* file, int line)
{
    std::fprintf(stderr, "carina: broken contract '%s' at %s:%d\n", condition, file, line);
    std::abort();
}

} // namespace carina::detail
