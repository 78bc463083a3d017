// Any bytes in a landmark file of another program: refused with a reason, or read as places in a
// room without a fault that a sanitizer sees. What the tables read they write and read again.

#include "engine/core/expects.h"
#include "engine/io/site/landmark_text.h"

#include <algorithm>

namespace
{

using namespace carina;

void verifyPlaces(const std::vector<Landmark>& landmarks)
{
    for (const Landmark& landmark : landmarks)
        CARINA_EXPECTS(landmark.p_AQ.allFinite() && landmark.p_AQ.cwiseAbs().maxCoeff() <= 1e3);
}

template <class Decode, class Encode>
void readTable(std::string_view text, const Decode& decode, const Encode& encode)
{
    const auto landmarks = decode(text);
    if (!landmarks) {
        CARINA_EXPECTS(!landmarks.error().detail.empty());
        return;
    }
    verifyPlaces(*landmarks);
    const auto isNear = [](const Landmark& l) { return l.p_AQ.cwiseAbs().maxCoeff() < 999.0; };
    if (!std::ranges::all_of(*landmarks, isNear))
        return; // one rounded up to a kilometre is refused
    const auto again = decode(encode(*landmarks));
    CARINA_EXPECTS(again && again->size() == landmarks->size());
    for (std::size_t i = 0; i < again->size(); ++i)
        CARINA_EXPECTS((*again)[i].name == (*landmarks)[i].name);
}

} // namespace

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const std::string_view text{reinterpret_cast<const char*>(data) + 1, size - 1};
    if (data[0] == '0') {
        readTable(text, decodeLandmarkTable, encodeLandmarkTable);
    } else if (data[0] == '1') {
        readTable(text, decodeSlicerPoints, encodeSlicerPoints);
    } else if (const auto catalogue = decodeSlicerMarkups(text)) {
        verifyPlaces(catalogue->landmarks);
    }
    return 0;
}
