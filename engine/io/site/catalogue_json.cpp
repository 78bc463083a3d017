#include "engine/io/site/catalogue_json.h"

namespace carina
{
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
    fields.allowOnly({"name", "anatomy", "landmarks"});
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

} // namespace carina
