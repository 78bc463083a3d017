#include "engine/io/anatomy_set/builtin_cache.h"

#include "engine/anatomy/patient/patient_name.h"

#include <utility>

namespace carina
{

Result<Anatomy> cachedPatient(const PatientParameters& parameters,
                              const std::filesystem::path& cacheFolder, Posture posture)
{
    const AnatomyCache cache{cacheFolder};
    const std::string hash = (posture == Posture::Rest ? "at-rest-" : "") + madeHash(parameters);
    if (auto kept = cache.load(hash)) {
        kept->anatomy.name = nameOf(parameters); // the hash does not depend on it
        return std::move(kept->anatomy);
    }
    return patientFor(parameters, posture).map([&](Anatomy&& made) {
        made.contentHash = hash;
        ImportedSet set{.anatomy = std::move(made), .frame = {}, .faults = {}, .leftOut = {}};
        static_cast<void>(cache.store(set)); // it can be made again
        return std::move(set.anatomy);
    });
}

} // namespace carina
