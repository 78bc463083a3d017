#include "engine/io/files/json_fields.h"
#include "engine/io/site/landmark_text.h"

#include <QJsonDocument>

namespace carina
{
namespace
{

const QString kMarkupsSchema =
    QStringLiteral("https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/"
                   "Markups/Resources/Schema/markups-schema-v1.0.3.json#");

/// The one list of points among the markups.
std::optional<JsonFields> pointListIn(JsonFields& fields)
{
    std::optional<JsonFields> list;
    for (JsonFields& markup : fields.objects("markups")) {
        if (markup.text("type") != "Fiducial")
            continue;
        if (list)
            fields.refuse("markups", "there is more than one list of points");
        list = markup;
    }
    if (!list)
        fields.refuse("markups", "there is no list of points (type Fiducial)");
    return list;
}

/// From the axes of a list to those of A, which are LPS.
Vec3 signsOf(JsonFields& list)
{
    const std::string axes = list.has("coordinateSystem") ? list.text("coordinateSystem") : "LPS";
    if (axes != "LPS" && axes != "RAS")
        list.refuse("coordinateSystem", "LPS or RAS are expected");
    const std::string unit = list.has("coordinateUnits") ? list.firstText("coordinateUnits") : "mm";
    if (unit != "mm")
        list.refuse("coordinateUnits", "millimetres are expected (\"mm\")");
    return axes == "RAS" ? Vec3{-1.0, -1.0, 1.0} : Vec3::Ones();
}

} // namespace

Result<LandmarkCatalogue> decodeSlicerMarkups(std::string_view text)
{
    const Result<QJsonObject> object = jsonObjectIn(text);
    if (!object)
        return tl::unexpected(object.error());
    std::optional<Error> fault;
    JsonFields fields{*object, fault};
    const std::string schema = fields.text("@schema");
    if (!fault && schema.find("markups-schema-v1.") == std::string::npos)
        return fail(Errc::UnknownFormat,
                    "@schema: it is " + schema + ", and one of markups-schema-v1 is expected");
    LandmarkCatalogue catalogue;
    if (auto list = pointListIn(fields)) {
        const Vec3 signs = signsOf(*list);
        if (list->has("name"))
            catalogue.name = list->text("name");
        for (JsonFields& point : list->objects("controlPoints")) {
            catalogue.landmarks.push_back(
                {point.text("label"), signs.cwiseProduct(point.point("position"))});
            if (point.has("positionStatus") && point.text("positionStatus") != "defined")
                point.refuse("positionStatus", "the point was not placed");
        }
    }
    if (fault)
        return tl::unexpected(*fault);
    return catalogue;
}

std::string encodeSlicerMarkups(const LandmarkCatalogue& catalogue)
{
    QJsonArray points;
    for (const Landmark& landmark : catalogue.landmarks)
        points.append(QJsonObject{{QStringLiteral("id"), QString::number(points.size() + 1)},
                                  {QStringLiteral("label"), QString::fromStdString(landmark.name)},
                                  {QStringLiteral("position"), jsonPoint(landmark.p_AQ)},
                                  {QStringLiteral("positionStatus"), QStringLiteral("defined")}});
    const QJsonObject list{{QStringLiteral("type"), QStringLiteral("Fiducial")},
                           {QStringLiteral("name"), QString::fromStdString(catalogue.name)},
                           {QStringLiteral("coordinateSystem"), QStringLiteral("LPS")},
                           {QStringLiteral("coordinateUnits"), QStringLiteral("mm")},
                           {QStringLiteral("controlPoints"), points}};
    const QJsonObject markups{{QStringLiteral("@schema"), kMarkupsSchema},
                              {QStringLiteral("markups"), QJsonArray{list}}};
    return QJsonDocument{markups}.toJson().toStdString();
}

} // namespace carina
