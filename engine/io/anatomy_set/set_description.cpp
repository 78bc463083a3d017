#include "engine/io/anatomy_set/set_description.h"

#include "engine/core/units.h"
#include "engine/geometry/mesh/mesh_winding.h"

#include <QJsonArray>

#include <array>

namespace carina
{
namespace
{

QString words(const std::string& text) { return QString::fromStdString(text); }

QJsonArray lines(const std::vector<std::string>& texts)
{
    QJsonArray array;
    for (const std::string& text : texts)
        array.append(words(text));
    return array;
}

QJsonArray pointInMillimetres(const Vec3& p_A)
{
    QJsonArray point;
    for (int axis = 0; axis < 3; ++axis)
        point.append(inMillimetres(metres(p_A[axis])));
    return point;
}

QJsonObject describePart(const AnatomyPart& part)
{
    const TriangleMesh& finest = part.levels.front();
    const bool closed = isClosed(finest);
    QJsonObject object{
        {QStringLiteral("name"), words(part.name)},
        {QStringLiteral("role"), QString::fromLatin1(roleName(part.role))},
        {QStringLiteral("concept_id"), words(part.conceptId)},
        {QStringLiteral("triangles"), static_cast<qint64>(finest.triangles.size())},
        {QStringLiteral("levels"), static_cast<qint64>(part.levels.size())},
        {QStringLiteral("closed"), closed},
    };
    if (closed)
        object.insert(QStringLiteral("volume_ml"),
                      inMillilitres(cubicMetres(signedVolume(finest))));
    return object;
}

/// The volumes of both lungs as sums of their parts; null for a side without one.
QJsonObject describeLungs(const Anatomy& anatomy)
{
    std::array<QJsonValue, 2> volumesMl;
    for (const AnatomyPart& part : anatomy.parts) {
        const std::optional<Side> side = lungSide(part.role);
        if (!side)
            continue;
        QJsonValue& sum = volumesMl[*side == Side::Right ? 0 : 1];
        sum = sum.toDouble() + inMillilitres(cubicMetres(signedVolume(part.levels.front())));
    }
    return {{QStringLiteral("right_ml"), volumesMl[0]}, {QStringLiteral("left_ml"), volumesMl[1]}};
}

QJsonValue describeLandmarks(const AirwayLandmarks& landmarks)
{
    if (landmarks.path_A.empty())
        return QJsonValue::Null;
    return QJsonObject{{QStringLiteral("incisors"), pointInMillimetres(landmarks.p_A_incisors)},
                       {QStringLiteral("glottis"), pointInMillimetres(landmarks.p_A_glottis)},
                       {QStringLiteral("carina"), pointInMillimetres(landmarks.p_A_carina)}};
}

} // namespace

QJsonObject describeSet(const ImportedSet& set)
{
    QJsonArray parts;
    qint64 triangles = 0;
    for (const AnatomyPart& part : set.anatomy.parts) {
        parts.append(describePart(part));
        triangles += static_cast<qint64>(part.levels.front().triangles.size());
    }
    QJsonArray faults;
    for (const FileFault& fault : set.faults)
        faults.append(QJsonObject{{QStringLiteral("file"), words(fault.file)},
                                  {QStringLiteral("fault"), words(fault.error.detail)}});
    return {
        {QStringLiteral("schema"), QStringLiteral("carina.anatomy/1")},
        {QStringLiteral("name"), words(set.anatomy.name)},
        {QStringLiteral("content_hash"), words(set.anatomy.contentHash)},
        {QStringLiteral("unit_mm"), inMillimetres(metres(set.frame.metresPerUnit))},
        {QStringLiteral("axes"), lines(axisWords(set.frame))},
        {QStringLiteral("parts"), parts},
        {QStringLiteral("lungs"), describeLungs(set.anatomy)},
        {QStringLiteral("triangles"), triangles},
        {QStringLiteral("landmarks_mm"), describeLandmarks(set.anatomy.landmarks)},
        {QStringLiteral("attributions"), lines(set.anatomy.attributions)},
        {QStringLiteral("faults"), faults},
        {QStringLiteral("left_out"), lines(set.leftOut)},
    };
}

} // namespace carina
