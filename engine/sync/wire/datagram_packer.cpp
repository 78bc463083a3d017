#include "engine/sync/wire/datagram_packer.h"

#include "engine/sync/wire/datagram_codec.h"
#include "engine/sync/wire/record_codec.h"

namespace carina
{

std::vector<std::vector<std::byte>> packDatagrams(std::span<const WireRecord> records,
                                                  const std::function<BundleHeader()>& nextHeader)
{
    std::vector<std::vector<std::byte>> datagrams{encodeHeader(nextHeader())};
    std::vector<std::byte> bytes;
    for (const WireRecord& record : records) {
        bytes.clear();
        ByteWriter out{bytes};
        writeRecord(out, record);
        if (datagrams.back().size() + bytes.size() > kLargestDatagram)
            datagrams.push_back(encodeHeader(nextHeader()));
        datagrams.back().insert(datagrams.back().end(), bytes.begin(), bytes.end());
    }
    return datagrams;
}

} // namespace carina
