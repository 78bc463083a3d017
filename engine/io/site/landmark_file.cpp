#include "engine/io/site/landmark_file.h"

namespace carina
{
namespace
{

const QString kLandmarkSchema = QStringLiteral("carina.landmarks/1");

} // namespace

QJsonObject jsonCatalogue(const LandmarkCatalogue& catalogue)
{
    QJsonArray landmarks;
    for (const Landmark& landmark : catalogue.landmarks)
        landmarks.append(
            QJsonObject{{QStringLiteral("name"), QString::fromStdString(landmark.name)},
                        {QStringLiteral("p_AQ_mm"), jsonPoint(landmark.p_AQ)}});
    QJsonObject object{{QStringLiteral("name"), QString::fromStdString(catalogue.name)},
                       {QStringLiteral("landmarks"), landmarks}};
    if (!catalogue.anatomy.empty())
        object.insert(QStringLiteral("anatomy"), QString::fromStdString(catalogue.anatomy));
    return object;
}

LandmarkCatalogue readCatalogue(JsonFields& fields)
{
    fields.allowOnly({"schema", "name", "anatomy", "landmarks"});
    LandmarkCatalogue catalogue{.name = fields.text("name"), .anatomy = {}, .landmarks = {}};
    if (fields.has("anatomy"))
        catalogue.anatomy = fields.text("anatomy");
    for (JsonFields& landmark : fields.objects("landmarks")) {
        landmark.allowOnly({"name", "p_AQ_mm"});
        catalogue.landmarks.push_back({landmark.text("name"), landmark.point("p_AQ_mm")});
    }
    if (const Result<void> sound = checkCatalogue(catalogue); !sound)
        fields.refuse("landmarks", sound.error().detail);
    return catalogue;
}

Result<LandmarkCatalogue> readLandmarkFile(const std::filesystem::path& file)
{
    const Result<QJsonObject> object = readJsonFile(file, kLandmarkSchema);
    if (!object)
        return tl::unexpected(object.error());
    std::optional<Error> fault;
    JsonFields fields{*object, fault};
    LandmarkCatalogue catalogue = readCatalogue(fields);
    if (fault)
        return fail(fault->code, file.string() + ": " + fault->detail);
    return catalogue;
}

Result<void> writeLandmarkFile(const std::filesystem::path& file,
                               const LandmarkCatalogue& catalogue)
{
    if (const Result<void> sound = checkCatalogue(catalogue); !sound)
        return sound;
    QJsonObject object = jsonCatalogue(catalogue);
    object.insert(QStringLiteral("schema"), kLandmarkSchema);
    return writeJsonFile(file, object);
}

} // namespace carina
