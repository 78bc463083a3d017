#include "apps/lab/vision/camera_uses.h"
#include "apps/lab/vision/still_jitter.h"
#include "engine/io/site/devices/camera_file.h"
#include "engine/vision/marker_watch.h"
#include "engine/vision/picture_source.h"

#include <QJsonArray>

#include <cmath>
#include <map>

namespace carina::lab
{
namespace
{

namespace markers_option
{
constexpr Option kCalibration{"calibration", "FILE",
                              "of the camera: carina.camera/1, or of OpenCV"};
constexpr Option kDictionary{"dictionary", "NAME",
                             "of the markers, such as 4x4_50, original or apriltag_36h11; unless "
                             "given the one of which most are seen"};
constexpr Option kSide{"side-mm", "MM", "of the black squares, 1 to 1000 (50)"};
constexpr Option kRate{"rate", "HZ", "pictures a second of a folder, 1 to 1000 (30)"};
} // namespace markers_option

namespace markers_key
{
constexpr Key kPlace{"place", "PLACE as given"};
constexpr Key kDictionary{"dictionary", "of the markers"};
constexpr Key kPictures{"pictures", "that were looked at"};
constexpr Key kWithMarker{"with_marker", "of these, with at least one marker"};
constexpr Key kWithPose{"with_pose", "of these, with the pose of at least one, ambiguous or not"};
constexpr Key kMarkers{"markers", "one object for each that is in three pictures or more:"};
constexpr Key kId{"id", "its number", 1};
constexpr Key kSeen{"seen", "pictures in which it is seen", 1};
constexpr Key kPoses{"poses", "of these, with a pose", 1};
constexpr Key kAmbiguous{"ambiguous", "of these, the pose or its mirror image: it is not known", 1};
constexpr Key kRms{"reprojection_px", "distance of corners from the pose's, RMS", 1};
constexpr Key kDistance{"distance_mm", "mean distance from the camera", 1};
constexpr Key kExpected{"expected_mm", "RMS error of the position that the covariance states, mean",
                        1};
constexpr Key kStill{"still",
                     "pictures in stretches of ten in which it is still: less than 0.5 mm "
                     "and 0.5 degrees between the means of both halves",
                     1};
constexpr Key kJitter{"jitter_mm",
                      "position about its mean in these stretches, RMS; null where none", 1};
constexpr Key kTurn{"jitter_deg", "rotation about its mean there, RMS; null where none", 1};
constexpr Key kSchema{"schema", "carina.camera-find/1"};
} // namespace markers_key

constexpr std::size_t kTried = 12; ///< pictures that tell the dictionary
constexpr int kFewest = 3;         ///< pictures with a marker, below which it is taken for an error

struct LookedAt {
    std::vector<DetectedMarker> seen;
    Duration time{};
};

/// What the pictures show of one marker.
struct MarkerFigures {
    int seen = 0;
    int poses = 0;
    int ambiguous = 0;
    double squares = 0.0;
    double distance = 0.0;
    double expected = 0.0;
    StillJitter jitter;
};

Result<std::vector<GreyPicture>> firstPictures(const PicturePlace& place)
{
    auto source = PictureSource::open(place);
    if (!source)
        return tl::unexpected(source.error());
    std::vector<GreyPicture> pictures;
    while (pictures.size() < kTried) {
        auto taken = source->next();
        if (!taken)
            break;
        pictures.push_back(std::move(taken->picture));
        for (int i = 0; i < 20; ++i)
            static_cast<void>(source->skip());
    }
    return pictures;
}

/// The dictionary of which most markers are seen; the first of several.
Result<MarkerDictionary> dictionaryIn(const PicturePlace& place)
{
    const auto pictures = firstPictures(place);
    if (!pictures)
        return tl::unexpected(pictures.error());
    MarkerDictionary best{};
    std::size_t most = 0;
    for (int i = 0; i <= int(MarkerDictionary::AprilTag36h11); ++i) {
        std::size_t seen = 0;
        for (const GreyPicture& picture : *pictures)
            seen += seenMarkers(picture, MarkerDictionary(i)).size();
        if (seen > most) {
            most = seen;
            best = MarkerDictionary(i);
        }
    }
    if (most == 0)
        return fail(Errc::NothingRecognised, place.path.string() + ": no marker of any dictionary");
    return best;
}

Result<MarkerDictionary> dictionaryOption(const Words& words, const PicturePlace& place)
{
    if (!words.has(markers_option::kDictionary))
        return dictionaryIn(place);
    const std::string name = words.text(markers_option::kDictionary).toStdString();
    QStringList known;
    for (std::size_t i = 0; i < std::size(kDictionaryWords); ++i) {
        if (name == kDictionaryWords[i])
            return MarkerDictionary(i);
        known += QString::fromLatin1(kDictionaryWords[i]);
    }
    return words.unknownWord(markers_option::kDictionary, known);
}

/// That of pictures of the same camera which were enlarged or reduced by a factor.
CameraModel enlarged(const CameraModel& camera, double factor)
{
    CameraModel larger = camera;
    larger.width = int(std::lround(factor * camera.width));
    larger.height = int(std::lround(factor * camera.height));
    const Vec2 half{0.5, 0.5}; // the centre of the first pixel is at (0, 0)
    larger.focal = factor * camera.focal;
    larger.centre = factor * (camera.centre + half) - half;
    return larger;
}

Result<std::vector<LookedAt>> lookThrough(const PicturePlace& place, MarkerDictionary dictionary,
                                          CameraModel& camera)
{
    auto source = PictureSource::open(place);
    if (!source)
        return tl::unexpected(source.error());
    std::vector<LookedAt> all;
    while (auto taken = source->next()) {
        if (all.empty())
            camera = enlarged(camera, double(taken->picture.width) / camera.width);
        if (taken->picture.width != camera.width || taken->picture.height != camera.height)
            return fail(Errc::OutOfRange, place.path.string() + ": its pictures have "
                                              + std::to_string(taken->picture.width) + " x "
                                              + std::to_string(taken->picture.height)
                                              + " pixels, other than the calibration");
        all.push_back({seenMarkers(taken->picture, dictionary), taken->time});
    }
    return all;
}

QJsonObject objectOf(int id, const MarkerFigures& figures)
{
    const double poses = std::max(figures.poses, 1);
    const auto orNull = [](std::optional<double> value) {
        return value ? QJsonValue{*value} : QJsonValue{};
    };
    return {{markers_key::kId, id},
            {markers_key::kSeen, figures.seen},
            {markers_key::kPoses, figures.poses},
            {markers_key::kAmbiguous, figures.ambiguous},
            {markers_key::kRms, std::sqrt(figures.squares / poses)},
            {markers_key::kDistance, 1e3 * figures.distance / poses},
            {markers_key::kExpected, 1e3 * figures.expected / poses},
            {markers_key::kStill, figures.jitter.samples()},
            {markers_key::kJitter, orNull(figures.jitter.position_mm())},
            {markers_key::kTurn, orNull(figures.jitter.rotation_deg())}};
}

QJsonObject describePictures(const std::vector<LookedAt>& pictures, const CameraModel& camera,
                             MarkerDictionary dictionary, double side)
{
    std::map<int, int> seen;
    for (const LookedAt& picture : pictures)
        for (const DetectedMarker& marker : picture.seen)
            ++seen[marker.id];
    std::erase_if(seen, [](const auto& entry) { return entry.second < kFewest; });
    WatchedBodies watched{camera, dictionary, {}};
    for (const auto& [id, times] : seen)
        watched.bodies.push_back({{id, side, {}}});
    MarkerWatch watch{watched};
    std::vector<MarkerFigures> figures(seen.size());
    int withMarker = 0;
    int withPose = 0;
    for (const LookedAt& picture : pictures) {
        const std::vector<BodySight> sights = watch.look(picture.seen, picture.time);
        bool hasMarker = false;
        bool hasPose = false;
        for (std::size_t i = 0; i < sights.size(); ++i) {
            const BodySight& sight = sights[i];
            hasMarker |= sight.markers > 0;
            hasPose |= sight.pose.has_value();
            figures[i].seen += sight.markers;
            const bool isKnown = sight.pose && !sight.isAmbiguous;
            figures[i].jitter.add(isKnown ? std::optional{sight.pose->X_TB} : std::nullopt);
            if (!sight.pose)
                continue;
            ++figures[i].poses;
            figures[i].ambiguous += sight.isAmbiguous ? 1 : 0;
            figures[i].squares += sight.pose->rms * sight.pose->rms;
            figures[i].distance += sight.pose->X_TB.translation().norm();
            figures[i].expected += expectedError(*sight.pose).position;
        }
        withMarker += hasMarker ? 1 : 0;
        withPose += hasPose ? 1 : 0;
    }
    QJsonArray markers;
    std::size_t at = 0;
    for (const auto& [id, times] : seen)
        markers.append(objectOf(id, figures[at++]));
    return {
        {markers_key::kSchema, QLatin1StringView{markers_key::kSchema.help}},
        {markers_key::kDictionary, QString::fromLatin1(kDictionaryWords[std::size_t(dictionary)])},
        {markers_key::kPictures, qint64(pictures.size())},
        {markers_key::kWithMarker, withMarker},
        {markers_key::kWithPose, withPose},
        {markers_key::kMarkers, markers}};
}

} // namespace

Result<QJsonObject> findMarkers(const Words& words)
{
    if (!words.has(markers_option::kCalibration))
        return words.refuse(QStringLiteral("find needs --calibration FILE."));
    const auto side = words.number(markers_option::kSide, 1.0, 1000.0, 50.0);
    const auto rate = words.number(markers_option::kRate, 1.0, 1000.0, 30.0);
    if (!side || !rate)
        return tl::unexpected(!side ? side.error() : rate.error());
    const std::filesystem::path path{words.files()[1].toStdString()};
    const PicturePlace place{.kind = kindOfPlace(path), .path = path, .rate = *rate};
    if (place.kind == PicturePlace::Kind::Camera)
        return words.refuse(QStringLiteral("find takes a video or a folder, which have an end."));
    auto camera = readCameraFile(words.text(markers_option::kCalibration).toStdString());
    if (!camera)
        return tl::unexpected(camera.error());
    const auto dictionary = dictionaryOption(words, place);
    if (!dictionary)
        return tl::unexpected(dictionary.error());
    return lookThrough(place, *dictionary, camera->model)
        .map([&](const std::vector<LookedAt>& pictures) {
            QJsonObject object =
                describePictures(pictures, camera->model, *dictionary, 1e-3 * *side);
            object[markers_key::kPlace] = words.files()[1];
            return object;
        });
}

Use findUse()
{
    return {.lines = {"find PLACE --calibration FILE [--dictionary NAME] [--side-mm MM] "
                      "[--rate HZ]"},
            .text = "Looks at each picture of PLACE, a video or a folder of PNG and JPEG "
                    "files, for square markers of ArUco or AprilTag, all of one size, "
                    "and prints how well each is seen. Pictures that were enlarged since the "
                    "calibration, in proportion, are taken with the calibration enlarged.",
            .options = {markers_option::kCalibration, markers_option::kDictionary,
                        markers_option::kSide, markers_option::kRate},
            .schema = markers_key::kSchema,
            .keys = {markers_key::kPlace, markers_key::kDictionary, markers_key::kPictures,
                     markers_key::kWithMarker, markers_key::kWithPose, markers_key::kMarkers,
                     markers_key::kId, markers_key::kSeen, markers_key::kPoses,
                     markers_key::kAmbiguous, markers_key::kRms, markers_key::kDistance,
                     markers_key::kExpected, markers_key::kStill, markers_key::kJitter,
                     markers_key::kTurn}};
}

} // namespace carina::lab
