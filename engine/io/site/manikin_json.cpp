#include "engine/io/site/manikin_json.h"

#include "engine/io/site/json_text.h"

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

const QString kManikinSchema = QStringLiteral("carina.manikin/1");
constexpr std::array kPlaceWords{"incisors", "epiglottis", "glottis", "carina"};

/// A text that has to be there if another field is.
std::string readSource(JsonFields& fields, const char* key, bool isDue)
{
    return isDue ? fields.text(key) : readText(fields, key);
}

Length readTeethToCarina(JsonFields& fields, const char* key)
{
    const Length length = metres(fields.length(key));
    if (length < kLeastTeethToCarina || length > kMostTeethToCarina)
        fields.refuse(key, "teeth to carina are 100 to 350 mm");
    return length;
}

SourcedLength readSourcedLength(JsonFields fields)
{
    fields.allowOnly({"mm", "source"});
    const Length length = readTeethToCarina(fields, "mm");
    return {length, fields.text("source")};
}

std::vector<std::string> readLandmarkNames(JsonFields& fields)
{
    std::vector<std::string> names;
    if (!fields.has("landmarks"))
        return names;
    for (JsonFields& landmark : fields.objects("landmarks")) {
        landmark.allowOnly({"name"});
        const std::string name = landmark.text("name");
        if (std::ranges::count(names, name) > 0)
            landmark.refuse("name", "\"" + name + "\" is there twice");
        names.push_back(name);
    }
    return names;
}

std::vector<TouchedAirwayPlace> readAirway(JsonFields& fields)
{
    std::vector<TouchedAirwayPlace> airway;
    for (JsonFields& touched : fields.objects("airway")) {
        touched.allowOnly({"place", "p_MQ_mm"});
        const auto place = static_cast<AirwayPlace>(touched.oneOf("place", kPlaceWords));
        if (std::ranges::count(airway, place, &TouchedAirwayPlace::place) > 0)
            touched.refuse("place", "it is there twice");
        airway.push_back({place, touched.point("p_MQ_mm")});
    }
    return airway;
}

QJsonArray jsonAirway(const std::vector<TouchedAirwayPlace>& airway)
{
    QJsonArray list;
    for (const TouchedAirwayPlace& touched : airway) {
        const char* place = kPlaceWords[static_cast<std::size_t>(touched.place)];
        list.append(QJsonObject{{QStringLiteral("place"), QString::fromLatin1(place)},
                                {QStringLiteral("p_MQ_mm"), jsonPoint(touched.p_MQ)}});
    }
    return list;
}

/// @pre the schema was looked at.
ManikinProfile readProfileFields(JsonFields& fields)
{
    ManikinProfile profile{.name = fields.text("name"),
                           .note = readText(fields, "note"),
                           .landmarks = readLandmarkNames(fields),
                           .patient = readText(fields, "patient")};
    profile.landmarksSource = readSource(fields, "landmarks_source", !profile.landmarks.empty());
    profile.patientSource = readSource(fields, "patient_source", !profile.patient.empty());
    if (fields.has("teeth_to_carina"))
        profile.teethToCarina = readSourcedLength(fields.object("teeth_to_carina"));
    return profile;
}

} // namespace

QJsonObject jsonManikinProfile(const ManikinProfile& profile)
{
    QJsonObject object{{QStringLiteral("name"), jsonWords(profile.name)}};
    insertText(object, "note", profile.note);
    QJsonArray landmarks;
    for (const std::string& name : profile.landmarks)
        landmarks.append(QJsonObject{{QStringLiteral("name"), jsonWords(name)}});
    if (!landmarks.isEmpty())
        object.insert(QStringLiteral("landmarks"), landmarks);
    insertText(object, "landmarks_source", profile.landmarksSource);
    insertText(object, "patient", profile.patient);
    insertText(object, "patient_source", profile.patientSource);
    if (const auto& known = profile.teethToCarina)
        object.insert(QStringLiteral("teeth_to_carina"),
                      QJsonObject{{QStringLiteral("mm"), inMillimetres(known->length)},
                                  {QStringLiteral("source"), jsonWords(known->source)}});
    return object;
}

ManikinProfile readManikinProfile(JsonFields& fields)
{
    fields.allowOnly({"name", "note", "landmarks", "landmarks_source", "patient", "patient_source",
                      "teeth_to_carina"});
    return readProfileFields(fields);
}

QJsonObject jsonManikin(const SiteManikin& manikin)
{
    QJsonObject object;
    if (manikin.profile)
        object.insert(QStringLiteral("profile"), jsonManikinProfile(*manikin.profile));
    if (manikin.measuredTeethToCarina)
        object.insert(QStringLiteral("measured_teeth_to_carina_mm"),
                      inMillimetres(*manikin.measuredTeethToCarina));
    if (!manikin.airway.empty())
        object.insert(QStringLiteral("airway"), jsonAirway(manikin.airway));
    insertText(object, "registered_at", manikin.registeredAt);
    return object;
}

SiteManikin readManikin(JsonFields& fields)
{
    fields.allowOnly({"profile", "measured_teeth_to_carina_mm", "airway", "registered_at"});
    SiteManikin manikin;
    if (fields.has("profile")) {
        JsonFields profile = fields.object("profile");
        manikin.profile = readManikinProfile(profile);
    }
    if (fields.has("measured_teeth_to_carina_mm"))
        manikin.measuredTeethToCarina = readTeethToCarina(fields, "measured_teeth_to_carina_mm");
    if (fields.has("airway"))
        manikin.airway = readAirway(fields);
    manikin.registeredAt = readText(fields, "registered_at");
    return manikin;
}

Result<ManikinProfile> readManikinFile(const std::filesystem::path& file)
{
    const auto object = readJsonFile(file, kManikinSchema);
    if (!object)
        return tl::unexpected(object.error());
    std::optional<Error> fault;
    JsonFields fields{*object, fault};
    fields.allowOnly({"schema", "name", "note", "landmarks", "landmarks_source", "patient",
                      "patient_source", "teeth_to_carina"});
    ManikinProfile profile = readProfileFields(fields);
    if (fault)
        return fail(fault->code, file.string() + ": " + fault->detail);
    return profile;
}

} // namespace carina
