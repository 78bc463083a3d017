#include "apps/lab/rendering/error_pictures.h"

#include "apps/lab/rendering/picture_series.h"
#include "apps/lab/rendering/render_page.h"
#include "engine/registration/error/error_quadric.h"
#include "engine/registration/error/target_error.h"
#include "engine/registration/landmarks/bone_landmarks.h"
#include "models/patient/patient_source.h"
#include "ui/scene/scene_parts.h"
#include "widgets/error_scale.h"

#include <QJsonArray>
#include <QPainter>

#include <array>

namespace carina::lab
{
namespace
{

constexpr int kMargin = 8; ///< pixels between the scale and the corner

struct NamedMapView {
    const char* name;
    ViewPreset preset;
    std::optional<Section> section{};
};
const std::array kMapViews{
    NamedMapView{"front", ViewPreset::Front}, NamedMapView{"side", ViewPreset::Right},
    NamedMapView{"trainee", ViewPreset::Trainee},
    NamedMapView{"cut", ViewPreset::Right, Section{-Vec3::UnitX(), 0.0, Cut::All}}};

/// On the bones of a patient that has them, else by its height.
std::vector<Landmark> landmarksOf(const Anatomy& anatomy, Length height, std::size_t count)
{
    std::vector<Bone> bones;
    for (const AnatomyPart& part : anatomy.parts)
        if (part.role == PartRole::Rib)
            bones.push_back({part.name, part.levels.front().positions});
    const LandmarkCatalogue ribCage =
        boneLandmarks(bones, {}).value_or(ribCageCatalogue(height, {}));
    std::vector<Landmark> landmarks =
        ribCageAndJawCatalogue(ribCage, furtherPlaces(height)).landmarks;
    landmarks.resize(count);
    return landmarks;
}

Result<Mat4> quadricOf(const std::vector<Landmark>& landmarks, Length fle)
{
    std::vector<Vec3> places;
    for (const Landmark& landmark : landmarks)
        places.push_back(landmark.p_AQ);
    return fitCovariance(equalErrors(places, fle)).map(errorQuadric);
}

/// A picture with the scale in its lower left corner.
QImage withScale(const QImage& picture, ErrorScale& scale)
{
    QImage together = picture;
    QPainter painter{&together};
    painter.drawPixmap(kMargin, picture.height() - scale.height() - kMargin, scale.grab());
    return together;
}

Result<QJsonArray> drawAll(const std::vector<ScenePart>& parts, const SceneFrame& frame,
                           const ErrorMap& map, const ErrorRange& range,
                           const ErrorPictureOrder& order)
{
    ErrorScale scale;
    scale.setScale(map.bands, range);
    scale.resize(scale.sizeHint());
    QJsonArray pictures;
    const PictureSeries series{
        .count = kMapViews.size(),
        .size = order.size,
        .prepare =
            [&](SceneView& view) {
                view.setParts(parts);
                view.setFixedLevel(0);
                view.setErrorMap(map);
            },
        .frame =
            [&](SceneView& view, std::size_t i) {
                view.showFrom(kMapViews[i].preset);
                view.setSection(kMapViews[i].section);
                return frame;
            },
        .take = [&](SceneView&, std::size_t i, const QImage& picture) -> Result<void> {
            const QString name = QString::fromLatin1(kMapViews[i].name);
            const QString file = QStringLiteral("error-%1.png").arg(name);
            const QString path = order.folder.filePath(file);
            if (!withScale(picture, scale).save(path))
                return fail(Errc::FileUnwritable, path.toStdString() + " cannot be written.");
            pictures.append(
                QJsonObject{{render_error_key::kFile, file}, {render_error_key::kView, name}});
            return {};
        }};
    return drawSeries(series).map([&] { return pictures; });
}

} // namespace

Result<QJsonObject> drawErrorPictures(Subject subject, const ErrorPictureOrder& order)
{
    if (!order.folder.mkpath(QStringLiteral(".")))
        return fail(Errc::FileUnwritable, order.folder.path().toStdString() + " cannot be made.");
    const std::vector<Landmark> landmarks =
        landmarksOf(subject.anatomy, subject.build.height, order.landmarks);
    const Result<Mat4> quadric = quadricOf(landmarks, order.fle);
    if (!quadric)
        return tl::unexpected(quadric.error());
    const auto patient = patientOf(std::move(subject.anatomy));
    if (!patient)
        return tl::unexpected(patient.error());
    const std::vector<ScenePart> parts = sceneParts(**patient);
    const SceneFrame frame = sceneFrame({}, (*patient)->lungs().field());
    const ErrorRange range = errorRange(*quadric, parts, frame).value_or(ErrorRange{});
    const ErrorMap map{*quadric, bandsOver(range)};
    return drawAll(parts, frame, map, range, order).map([&](const QJsonArray& pictures) {
        return QJsonObject{
            {render_error_key::kSchema, QLatin1StringView{render_error_key::kSchema.help}},
            {render_error_key::kAnatomy, QString::fromStdString((*patient)->name())},
            {render_error_key::kLandmarks, static_cast<qint64>(landmarks.size())},
            {render_error_key::kTouchError, inMillimetres(order.fle)},
            {render_error_key::kLeastError, inMillimetres(range.least)},
            {render_error_key::kMostError, inMillimetres(range.most)},
            {render_error_key::kBand, inMillimetres(map.bands.width)},
            {render_error_key::kPictures, pictures}};
    });
}

} // namespace carina::lab
