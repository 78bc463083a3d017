#include "engine/net/objects/pose_stream.h"

namespace carina
{
namespace
{

StreamValidity streamed(Validity validity)
{
    switch (validity) {
    case Validity::Tracked:
        return StreamValidity::Tracked;
    case Validity::PartlyOccluded:
        return StreamValidity::PartlyOccluded;
    case Validity::Lost:
        break;
    }
    return StreamValidity::Lost;
}

Validity unstreamed(StreamValidity validity)
{
    switch (validity) {
    case StreamValidity::Tracked:
        return Validity::Tracked;
    case StreamValidity::PartlyOccluded:
        return Validity::PartlyOccluded;
    case StreamValidity::Lost:
        break;
    }
    return Validity::Lost;
}

} // namespace

StreamCpo toStream(const PoseSample& sample)
{
    StreamCpo cpo;
    cpo.time = sample.time;
    cpo.X_AO = sample.X_FO;
    if (sample.motion)
        cpo.motion = StreamMotion{sample.motion->v_FO, sample.motion->w_FO};
    cpo.validity = streamed(sample.validity);
    cpo.error = sample.error;
    return cpo;
}

PoseSample fromStream(const StreamCpo& cpo)
{
    PoseSample sample;
    sample.time = cpo.time;
    sample.X_FO = cpo.X_AO;
    if (cpo.motion)
        sample.motion = Motion{cpo.motion->v_AO, cpo.motion->w_AO};
    sample.validity = unstreamed(cpo.validity);
    sample.error = cpo.error;
    return sample;
}

} // namespace carina
