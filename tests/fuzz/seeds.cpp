// seed_datagrams DIR: a datagram with each record, for a fuzzer to begin with.

#include "tests/engine/sync/datagram_samples.h"

#include <fstream>

int main(int argc, char** argv)
{
    if (argc != 2)
        return 2;
    int number = 0;
    for (const carina::GoldenRecord& golden : carina::goldenRecords()) {
        const auto header = carina::fromHex(carina::kGoldenHeaderHex);
        const auto record = carina::fromHex(golden.hex);
        std::ofstream file{std::string{argv[1]} + '/' + std::to_string(++number), std::ios::binary};
        for (const auto& bytes : {header, record})
            file.write(reinterpret_cast<const char*>(bytes.data()),
                       static_cast<std::streamsize>(bytes.size()));
        if (!file)
            return 1;
    }
    return 0;
}
