// Any bytes in the place of a Polaris' replies, or of a recorded conversation with one: refused
// with a reason, or read as poses that are proper, however they are cut. The first byte chooses
// what reads them, the next two are the options of TX and BX.

#include "engine/core/expects.h"
#include "engine/tracking/ndi/ndi_conversation.h"
#include "engine/tracking/ndi/ndi_reply.h"
#include "tests/engine/tracking/ndi/ndi_samples.h"

#include <cmath>
#include <sstream>

namespace
{

using namespace carina;
using Reader = test::NdiSample::Reader;

void verify(const Result<NdiFrame>& frame, std::size_t bytes)
{
    if (!frame) {
        CARINA_EXPECTS(!frame.error().detail.empty());
        return;
    }
    CARINA_EXPECTS(frame->tools.size() <= bytes && frame->p_TStrays.size() <= bytes);
    for (const NdiTool& tool : frame->tools) {
        CARINA_EXPECTS(tool.X_TO || validityOf(tool) == Validity::Lost);
        if (tool.X_TO)
            CARINA_EXPECTS(tool.X_TO->translation().allFinite()
                           && std::abs(tool.X_TO->rotation().norm() - 1.0) < 1e-9);
    }
}

/// The replies in a stream, whether it comes as one piece or as many.
std::vector<NdiReply> repliesIn(std::string_view stream, std::size_t piece)
{
    std::vector<NdiReply> replies;
    NdiReplyReader reader;
    for (; !stream.empty(); stream.remove_prefix(std::min(piece, stream.size()))) {
        reader.take(stream.substr(0, piece));
        while (const auto reply = reader.next())
            if (*reply)
                replies.push_back(**reply);
    }
    return replies;
}

} // namespace

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size < 3)
        return 0;
    const auto options = static_cast<std::uint16_t>(data[1] | (data[2] << 8U));
    const std::string_view rest{reinterpret_cast<const char*>(data) + 3, size - 3};
    switch (static_cast<Reader>(data[0] % 5)) {
    case Reader::Tx:
        verify(decodeTx(rest, options), size);
        break;
    case Reader::Bx:
        verify(decodeBx(std::as_bytes(std::span{rest}), options), size);
        break;
    case Reader::Bx2:
        verify(decodeBx2(std::as_bytes(std::span{rest})), size);
        break;
    case Reader::Stream:
        CARINA_EXPECTS(rest.size() > kLongestNdiReply
                       || repliesIn(rest, rest.size()) == repliesIn(rest, 1 + options % 7U));
        break;
    case Reader::Recording:
        std::istringstream input{std::string{rest}};
        if (const auto recording = readNdiRecording(input, "fuzz"))
            for (const RecordedNdiFrame& recorded : decode(*recording).frames)
                verify(recorded.frame, size);
    }
    return 0;
}
