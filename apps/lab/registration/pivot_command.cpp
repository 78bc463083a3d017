#include "apps/lab/command/csv_table.h"
#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/registration/landmark_table.h"
#include "apps/lab/registration/recorded_stylus.h"
#include "engine/io/files/file_limit.h"
#include "engine/io/files/json_fields.h"
#include "engine/registration/calibration/pivot_calibration.h"
#include "engine/registration/calibration/spin_calibration.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <optional>

namespace carina::lab
{
namespace
{

namespace pivot_option
{
constexpr Option kLimit{"limit-mm", "MM",
                        "a pose whose tip is further from the divot is left out; 3 unless given"};
constexpr Option kSpin{"spin", "X,Y,Z",
                       "a point in the frame of the tool, mm, to which the axis points, such as "
                       "the tip"};
} // namespace pivot_option

namespace pivot_key
{
constexpr Key kTipSchema{"schema", "carina.pivot/1"};
constexpr Key kTip{"tip_mm", "[x, y, z] of the tip in the frame of the stylus"};
constexpr Key kPivot{"pivot_mm", "[x, y, z] of the divot in the frame of the poses"};
constexpr Key kRms{"rms_mm", "root mean square distance of the tips from the divot"};
constexpr Key kUncertainty{"uncertainty_mm",
                           "root mean square error of the tip that this noise causes"};
constexpr Key kReason{"reason", "where it is not acceptable: why, in words; else null. Poses "
                                "that determine no result at all have no figures but `poses`"};
constexpr Key kAxisSchema{"schema", "carina.spin/1"};
constexpr Key kAxis{"axis", "[x, y, z] of the axis in the frame of the tool, of length 1"};
constexpr Key kAxisPoint{"axis_point_mm",
                         "[x, y, z] of the point of the axis nearest to the origin of the tool"};
constexpr Key kWobble{"wobble_deg", "root mean square angle of the axis from its mean"};
constexpr Key kAxisRms{"rms_mm",
                       "root mean square distance of that point from its mean, across the axis"};
constexpr Key kAxisUncertainty{"uncertainty_deg",
                               "root mean square error of the axis that this wobble causes"};
constexpr Key kPoses{"poses", "that were read and tracked"};
constexpr Key kOutliers{"outliers", "of these, left out"};
constexpr Key kCoverage{"coverage", "how far each of three directions of the tool was turned, the "
                                    "one that turned least first:"};
constexpr Key kDirection{"direction", "[x, y, z] in the frame of the tool", 1};
constexpr Key kTurn{"turn_deg", "root mean square", 1};
constexpr Key kLeastTurned{"least_turned", "[x, y, z] of the first of these directions in its mean "
                                           "orientation, in the frame of the poses"};
} // namespace pivot_key

/// What a command line needs.
constexpr const char* kPivotReminder =
    "pivot needs one file or folder of poses, with --limit-mm above 0 or --spin X,Y,Z or neither.";

/// Devices round what they report.
constexpr double kRoundedRotation = 5e-3;

Result<std::vector<RigidTransform>> posesOfRecording(const QString& file)
{
    const Result<RecordedStylus> stylus = readRecordedStylus(file);
    if (!stylus)
        return tl::unexpected(stylus.error());
    std::vector<RigidTransform> poses;
    for (const PoseSample& sample : stylus->samples)
        if (sample.validity != Validity::Lost)
            poses.push_back(sample.X_FO);
    return poses;
}

Result<std::vector<RigidTransform>> posesOfTable(const QString& file)
{
    const auto table = CsvTable::read(file, {"tx", "ty", "tz", "qx", "qy", "qz", "qw"});
    if (!table)
        return tl::unexpected(table.error());
    std::vector<RigidTransform> poses;
    for (std::size_t row = 0; row < table->rows(); ++row) {
        Eigen::Matrix<double, 7, 1> numbers;
        for (int i = 0; i < 7; ++i) {
            const Result<double> number = table->number(row, static_cast<std::size_t>(i));
            if (!number)
                return tl::unexpected(number.error());
            numbers[i] = *number;
        }
        const Quat rotation{numbers.tail<4>().eval()};
        if (!numbers.allFinite() || !std::isnormal(rotation.norm()))
            return fail(Errc::NotFinite, file.toStdString() + ": pose " + std::to_string(row + 1)
                                             + " is not a valid pose.");
        poses.push_back({rotation, millimetres(1.0).si * numbers.head<3>()});
    }
    return poses;
}

Result<RigidTransform> readPoseText(const QString& file)
{
    const std::string name = file.toStdString();
    if (const auto good = readableSize(name, kDescriptionLimit); !good)
        return tl::unexpected(good.error());
    QFile source{file};
    if (!source.open(QIODevice::ReadOnly))
        return fail(Errc::FileUnreadable, name + " cannot be read.");
    const QString text = QString::fromLatin1(source.readAll());
    static const QRegularExpression kBetween{QStringLiteral("[\\s,;]+")};
    const QStringList words = text.split(kBetween, Qt::SkipEmptyParts);
    Mat4 matrix;
    bool areNumbers = words.size() == 16;
    for (int i = 0; areNumbers && i < 16; ++i)
        matrix(i / 4, i % 4) = words[i].toDouble(&areNumbers);
    if (!areNumbers)
        return fail(Errc::FileMalformed, name + " does not have the 16 numbers of a pose.");
    matrix.topRightCorner<3, 1>() *= millimetres(1.0).si;
    const auto X_TS = RigidTransform::fromMatrix(matrix, kRoundedRotation);
    if (!X_TS)
        return fail(X_TS.error().code, name + ": " + X_TS.error().detail + ".");
    return X_TS;
}

Result<std::vector<RigidTransform>> posesOfFolder(const QString& folder)
{
    std::vector<RigidTransform> poses;
    const QDir dir{folder};
    for (const QString& file : dir.entryList({QStringLiteral("*.txt")}, QDir::Files, QDir::Name)) {
        const Result<RigidTransform> X_TS = readPoseText(dir.filePath(file));
        if (!X_TS)
            return tl::unexpected(X_TS.error());
        poses.push_back(*X_TS);
    }
    if (poses.empty())
        return fail(Errc::NothingRecognised, folder.toStdString() + " holds no file *.txt.");
    return poses;
}

Result<std::vector<RigidTransform>> posesOf(const QString& path)
{
    if (QFileInfo{path}.isDir())
        return posesOfFolder(path);
    if (path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive))
        return posesOfTable(path);
    return posesOfRecording(path);
}

QJsonArray directionOf(const Vec3& d) { return {d.x(), d.y(), d.z()}; }

/// What tips and axes have in common.
QJsonObject describeTurns(const Key& schema, std::size_t poses, int outliers,
                          const TurnCoverage& coverage)
{
    QJsonArray directions;
    for (std::size_t i = 0; i < coverage.turns.size(); ++i)
        directions.append(QJsonObject{{pivot_key::kDirection, directionOf(coverage.dirs_S[i])},
                                      {pivot_key::kTurn, inDegrees(coverage.turns[i])}});
    return {{schema, QLatin1StringView{schema.help}},
            {pivot_key::kPoses, static_cast<qint64>(poses)},
            {pivot_key::kOutliers, outliers},
            {pivot_key::kCoverage, directions},
            {pivot_key::kLeastTurned, directionOf(coverage.dir_T_least)}};
}

void insertVerdict(QJsonObject& object, const std::optional<Error>& refusal)
{
    object.insert(kAcceptable, !refusal);
    object.insert(pivot_key::kReason,
                  refusal ? QJsonValue{QString::fromStdString(refusal->detail)} : QJsonValue{});
}

Result<QJsonObject> describeTip(std::span<const RigidTransform> poses, Length limit)
{
    const Result<PivotCalibration> pivot = calibratePivot(poses, {.outlierLimit = limit});
    if (!pivot)
        return tl::unexpected(pivot.error());
    QJsonObject object =
        describeTurns(pivot_key::kTipSchema, poses.size(), pivot->outliers, pivot->coverage);
    object.insert(pivot_key::kTip, jsonPoint(pivot->p_SQ));
    object.insert(pivot_key::kPivot, jsonPoint(pivot->p_TQ));
    object.insert(pivot_key::kRms, inMillimetres(metres(pivot->rms)));
    object.insert(pivot_key::kUncertainty, inMillimetres(metres(pivot->uncertainty())));
    insertVerdict(object, pivot->refusal);
    return object;
}

Result<QJsonObject> describeAxis(std::span<const RigidTransform> poses, const Vec3& p_S_ahead)
{
    const Result<SpinCalibration> spin = calibrateSpin(poses, p_S_ahead);
    if (!spin)
        return tl::unexpected(spin.error());
    QJsonObject object =
        describeTurns(pivot_key::kAxisSchema, poses.size(), spin->outliers, spin->coverage);
    object.insert(pivot_key::kAxis, directionOf(spin->axis_S));
    object.insert(pivot_key::kAxisPoint, jsonPoint(spin->p_SC));
    object.insert(pivot_key::kWobble, inDegrees(spin->wobble));
    object.insert(pivot_key::kAxisRms, inMillimetres(metres(spin->rms)));
    object.insert(pivot_key::kAxisUncertainty, inDegrees(spin->uncertainty));
    insertVerdict(object, spin->refusal);
    return object;
}

/// Whether sound poses were refused for how the tool was moved.
bool isOfTheMotion(Errc code)
{
    return code == Errc::NotEnoughMotion || code == Errc::NotEnoughSpin || code == Errc::ToolMoved;
}

QJsonObject withoutFigures(const Key& schema, std::size_t poses, const std::string& reason)
{
    return {{schema, QLatin1StringView{schema.help}},
            {pivot_key::kPoses, static_cast<qint64>(poses)},
            {kAcceptable, false},
            {pivot_key::kReason, QString::fromStdString(reason)}};
}

/// What is asked of the poses; a point ahead where it is the axis.
struct PivotQuestion {
    QString path;
    Length limit;
    std::optional<Vec3> p_S_ahead{};
};

tl::unexpected<Error> wrongUse(const std::string& fault)
{
    return fail(Errc::WrongOption, fault + ' ' + kPivotReminder);
}

/// Three numbers with commas between them.
std::optional<Vec3> pointAhead(const QString& text)
{
    const QStringList words = text.split(QLatin1Char{','});
    bool areNumbers = words.size() == 3;
    Vec3 p_mm = Vec3::Zero();
    for (int i = 0; areNumbers && i < 3; ++i)
        p_mm[i] = words[i].toDouble(&areNumbers);
    if (!areNumbers || !p_mm.allFinite())
        return std::nullopt;
    return millimetres(1.0).si * p_mm;
}

Result<PivotQuestion> questionOf(const Words& words)
{
    if (words.files().isEmpty())
        return wrongUse("No file and no folder is named.");
    const bool hasSpin = words.has(pivot_option::kSpin);
    if (words.has(pivot_option::kLimit) && hasSpin)
        return wrongUse("--limit-mm and --spin exclude each other.");
    const Result<Length> limit =
        positiveMillimetres(words, pivot_option::kLimit, PivotSettings{}.outlierLimit);
    if (!limit)
        return wrongUse(limit.error().detail);
    PivotQuestion question{.path = words.files().front(), .limit = *limit};
    if (!hasSpin)
        return question;
    const QString spin = words.text(pivot_option::kSpin);
    question.p_S_ahead = pointAhead(spin);
    if (!question.p_S_ahead)
        return wrongUse("--spin needs three numbers with commas between them, not '"
                        + spin.toStdString() + "'.");
    return question;
}

Result<QJsonObject> runPivot(const Words& words)
{
    const Result<PivotQuestion> question = questionOf(words);
    if (!question)
        return tl::unexpected(question.error());
    const auto poses = posesOf(question->path);
    if (!poses)
        return tl::unexpected(poses.error());
    auto object = question->p_S_ahead ? describeAxis(*poses, *question->p_S_ahead)
                                      : describeTip(*poses, question->limit);
    if (object)
        return object;
    const std::string reason = question->path.toStdString() + " does not determine the "
                               + (question->p_S_ahead ? "axis" : "tip") + ": "
                               + object.error().detail + ".";
    if (isOfTheMotion(object.error().code))
        return withoutFigures(question->p_S_ahead ? pivot_key::kAxisSchema : pivot_key::kTipSchema,
                              poses->size(), reason);
    return fail(object.error().code, reason);
}

std::vector<Note> poseNotes()
{
    return {{"FILE.igs.mha", "a recording with the tool Stylus, or with one tool only; where it "
                             "has the tool Reference too, poses are taken in its frame"},
            {"FILE.csv", "a line of column names in any order, then one line for each pose:"},
            {"  tx,ty,tz", "the origin of the tool, mm"},
            {"  qx,qy,qz,qw", "its rotation as a quaternion of any length but 0"},
            {"DIR", "all its files *.txt, each of 16 numbers: a 4x4 pose row by row, its "
                    "translation in mm; blanks, commas or line ends stand between the numbers"},
            {"example", "tx,ty,tz,qx,qy,qz,qw"},
            {"", "12.1,-40.3,-1102.7,0.02,-0.11,0.70,0.70"},
            {"", "... ; carina-lab pivot swung.csv --limit-mm 2"}};
}

Use tipUse()
{
    return {.lines = {"FILE|DIR [--limit-mm MM]"},
            .text =
                "Finds the tip of a stylus from its poses while it was swung with its tip in a "
                "divot: linear least squares over the poses that agree (random sample "
                "consensus, with the same draws each time). Where the result is uncertain, "
                "lean the stylus towards least_turned. A set of which fewer than half agree, or "
                "whose rms_mm is above 1.5, is printed as not acceptable; the registration "
                "program refuses it. So is one that was turned too little, or about one axis "
                "only, which determines no tip.",
            .notes = poseNotes(),
            .options = {pivot_option::kLimit},
            .schema = pivot_key::kTipSchema,
            .keys = {pivot_key::kTip, pivot_key::kPivot, pivot_key::kRms, pivot_key::kUncertainty,
                     kAcceptable, pivot_key::kReason, pivot_key::kPoses, pivot_key::kOutliers,
                     pivot_key::kCoverage, pivot_key::kDirection, pivot_key::kTurn,
                     pivot_key::kLeastTurned}};
}

Use axisUse()
{
    return {.lines = {"FILE|DIR --spin X,Y,Z"},
            .text = "Finds the axis of a tool from its poses while it was spun about that axis, "
                    "over the poses that agree. The files are the same.",
            .notes = {{"example", "carina-lab pivot spun.csv --spin 0,0,-120"}},
            .options = {pivot_option::kSpin},
            .schema = pivot_key::kAxisSchema,
            .keys = {pivot_key::kAxis, pivot_key::kAxisPoint, pivot_key::kWobble,
                     pivot_key::kAxisRms, pivot_key::kAxisUncertainty, kAcceptable,
                     pivot_key::kReason, pivot_key::kPoses, pivot_key::kOutliers,
                     pivot_key::kCoverage, pivot_key::kDirection, pivot_key::kTurn,
                     pivot_key::kLeastTurned}};
}

} // namespace

Command pivotCommand()
{
    return {.name = "pivot",
            .theme = "registration",
            .summary = "finds the tip of a swung stylus, or the axis of a spun tool",
            .uses = {tipUse(), axisUse()},
            .mostFiles = 1,
            .reminder = kPivotReminder,
            .experiment = runPivot};
}

} // namespace carina::lab
