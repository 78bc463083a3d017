// Any bytes as the manikin of a site file: refused with a reason, or read as a manikin that is
// written and read again.

#include "engine/core/expects.h"
#include "engine/io/site/manikin_json.h"

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace carina;
    const auto object = jsonObjectIn({reinterpret_cast<const char*>(data), size});
    if (!object)
        return 0;
    std::optional<Error> fault;
    JsonFields fields{*object, fault};
    const SiteManikin manikin = readManikin(fields);
    if (fault) {
        CARINA_EXPECTS(!fault->detail.empty());
        return 0;
    }
    for (const TouchedAirwayPlace& touched : manikin.airway)
        CARINA_EXPECTS(touched.p_MQ.allFinite() && touched.p_MQ.cwiseAbs().maxCoeff() <= 1e3);
    JsonFields again{jsonManikin(manikin), fault};
    CARINA_EXPECTS(readManikin(again).airway.size() == manikin.airway.size() && !fault);
    return 0;
}
