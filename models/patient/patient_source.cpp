#include "models/patient/patient_source.h"

#include "engine/anatomy/patient/patient_name.h"
#include "engine/io/anatomy_set/builtin_cache.h"
#include "engine/io/anatomy_set/carried_sets.h"
#include "engine/io/anatomy_set/set_hash.h"

namespace carina
{

Result<SharedPatientModel> patientOf(Anatomy anatomy)
{
    const auto made =
        parametersOfHash(anatomy.contentHash).value_or(parametersOf(BuiltinPatient::Adult));
    return dimensionsFor(made)
        .and_then([&](const PatientDimensions& dimensions) {
            return PatientModel::of(std::move(anatomy), dimensions.tubeInnerDiameter);
        })
        .map([](PatientModel&& model) -> SharedPatientModel {
            return std::make_shared<const PatientModel>(std::move(model));
        });
}

Result<SharedPatientModel> patientHere(const std::string& contentHash, const std::string& name,
                                       const std::filesystem::path& cacheFolder)
{
    if (const auto made = parametersOfHash(contentHash))
        return cachedPatient(*made, cacheFolder).and_then(patientOf);
    if (!isSetHash(contentHash))
        return fail(Errc::FileNotFound, contentHash);
    return AnatomyCache{cacheFolder}.load(contentHash).and_then([&](ImportedSet&& set) {
        set.anatomy.name = name;
        return patientOf(std::move(set.anatomy));
    });
}

Result<SharedPatientModel> patientCarried(const std::string& digest, const std::string& contentHash,
                                          const std::string& name,
                                          const std::filesystem::path& cacheFolder)
{
    return CarriedSets{cacheFolder}.load(digest, contentHash).and_then([&](ImportedSet&& set) {
        set.anatomy.name = name;
        return patientOf(std::move(set.anatomy));
    });
}

} // namespace carina
