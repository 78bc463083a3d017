#include "apps/lab/registration/pivot_command.h"

#include "apps/lab/command/command_options.h"
#include "apps/lab/command/csv_table.h"
#include "apps/lab/registration/landmark_table.h"
#include "apps/lab/registration/recorded_stylus.h"
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

constexpr std::string_view kPivotHelp =
    R"(pivot FILE|DIR [--limit-mm MM]
pivot FILE|DIR --spin X,Y,Z
    Finds the tip of a stylus from its poses while it was swung with its tip in a divot: linear
    least squares over the poses that agree (random sample consensus, the same draws each time).
    With --spin finds the axis of a tool from its poses while it was spun about that axis.
    FILE.igs.mha      a recording with the tool Stylus, or one tool only; where it has the tool
                      Reference too, poses are taken in its frame
    FILE.csv          a line of column names in any order, then one line for each pose:
      tx,ty,tz        the origin of the stylus, mm
      qx,qy,qz,qw     its rotation as a quaternion of any length but 0
    DIR               its files *.txt, each 16 numbers: a 4x4 pose row by row, translation in mm,
                      parted by blanks, commas or line ends
    example           tx,ty,tz,qx,qy,qz,qw
                      12.1,-40.3,-1102.7,0.02,-0.11,0.70,0.70
                      ... ; carina-lab pivot swung.csv --limit-mm 2
                      carina-lab pivot spun.csv --spin 0,0,-120
    --limit-mm MM     a pose whose tip is further from the divot is left out; 3 by default
    --spin X,Y,Z      a point in the frame of the tool, mm, to which the axis points, as the tip
    schema            "carina.pivot/1"
    tip_mm            [x, y, z] of the tip in the frame of the stylus
    pivot_mm          [x, y, z] of the divot in the frame of the poses
    rms_mm            root of the mean squared distance of the tips from the divot
    uncertainty_mm    root of the mean squared error of the tip that this noise makes
    poses             read and tracked
    outliers          of these, left out
    coverage          how far each of three directions of the stylus was turned, least first:
      direction       [x, y, z] in the frame of the stylus
      turn_deg        root mean square
    least_turned      the first direction as it stood on average, in the frame of the poses: lean the
                      stylus this way
    with --spin       schema is "carina.spin/1", and instead of tip and divot:
    axis              [x, y, z] of the axis in the frame of the tool, of length 1
    axis_point_mm     its point nearest to the origin of the tool
    wobble_deg        root of the mean squared angle of the axis from its mean
    rms_mm            root of the mean squared distance of that point from its mean, across the axis
    uncertainty_deg   root of the mean squared error of the axis that this wobble makes
)";

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
            return fail(Errc::NotFinite,
                        file.toStdString() + ": pose " + std::to_string(row + 1) + " is no pose.");
        poses.push_back({rotation, millimetres(1.0).si * numbers.head<3>()});
    }
    return poses;
}

Result<RigidTransform> readPoseText(const QString& file)
{
    const std::string name = file.toStdString();
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
        return fail(Errc::FileMalformed, name + " has not the 16 numbers of a pose.");
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
QJsonObject describeTurns(const char* schema, std::size_t poses, int outliers,
                          const TurnCoverage& coverage)
{
    QJsonArray directions;
    for (std::size_t i = 0; i < coverage.turns.size(); ++i)
        directions.append(
            QJsonObject{{QStringLiteral("direction"), directionOf(coverage.dirs_S[i])},
                        {QStringLiteral("turn_deg"), inDegrees(coverage.turns[i])}});
    return {{QStringLiteral("schema"), QString::fromLatin1(schema)},
            {QStringLiteral("poses"), static_cast<qint64>(poses)},
            {QStringLiteral("outliers"), outliers},
            {QStringLiteral("coverage"), directions},
            {QStringLiteral("least_turned"), directionOf(coverage.dir_T_least)}};
}

Result<QJsonObject> describeTip(std::span<const RigidTransform> poses, Length limit)
{
    const Result<PivotCalibration> pivot = calibratePivot(poses, {.outlierLimit = limit});
    if (!pivot)
        return tl::unexpected(pivot.error());
    QJsonObject object =
        describeTurns("carina.pivot/1", poses.size(), pivot->outliers, pivot->coverage);
    object.insert(QStringLiteral("tip_mm"), jsonPoint(pivot->p_SQ));
    object.insert(QStringLiteral("pivot_mm"), jsonPoint(pivot->p_TQ));
    object.insert(QStringLiteral("rms_mm"), inMillimetres(metres(pivot->rms)));
    object.insert(QStringLiteral("uncertainty_mm"), inMillimetres(metres(pivot->uncertainty())));
    return object;
}

Result<QJsonObject> describeAxis(std::span<const RigidTransform> poses, const Vec3& p_S_ahead)
{
    const Result<SpinCalibration> spin = calibrateSpin(poses, p_S_ahead);
    if (!spin)
        return tl::unexpected(spin.error());
    QJsonObject object =
        describeTurns("carina.spin/1", poses.size(), spin->outliers, spin->coverage);
    object.insert(QStringLiteral("axis"), directionOf(spin->axis_S));
    object.insert(QStringLiteral("axis_point_mm"), jsonPoint(spin->p_SC));
    object.insert(QStringLiteral("wobble_deg"), inDegrees(spin->wobble));
    object.insert(QStringLiteral("rms_mm"), inMillimetres(metres(spin->rms)));
    object.insert(QStringLiteral("uncertainty_deg"), inDegrees(spin->uncertainty));
    return object;
}

/// What is asked of the poses; a point ahead where it is the axis.
struct PivotQuestion {
    QString path;
    Length limit = PivotSettings{}.outlierLimit;
    std::optional<Vec3> p_S_ahead{};
};

tl::unexpected<Error> wrongUse(const std::string& fault)
{
    return fail(Errc::OutOfRange, fault
                                      + " pivot needs one file or folder of poses, with --limit-mm "
                                        "above 0 or --spin X,Y,Z or neither.");
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

Result<PivotQuestion> questionOf(const QStringList& arguments)
{
    const QString limit = QStringLiteral("limit-mm");
    const QString spin = QStringLiteral("spin");
    QCommandLineParser parser;
    addValueOptions(parser, {"limit-mm", "spin"});
    if (const auto parsed = parseOptions(parser, "pivot", arguments, 1); !parsed)
        return wrongUse(parsed.error().detail);
    if (parser.positionalArguments().isEmpty())
        return wrongUse("No file and no folder is named.");
    if (parser.isSet(limit) && parser.isSet(spin))
        return wrongUse("--limit-mm and --spin exclude each other.");
    PivotQuestion question{.path = parser.positionalArguments().front()};
    if (parser.isSet(limit)) {
        const auto given = positiveMillimetres(QStringLiteral("--limit-mm"), parser.value(limit));
        if (!given)
            return wrongUse(given.error().detail);
        question.limit = *given;
    }
    if (parser.isSet(spin)) {
        question.p_S_ahead = pointAhead(parser.value(spin));
        if (!question.p_S_ahead)
            return wrongUse("--spin needs three numbers with commas between them, not '"
                            + parser.value(spin).toStdString() + "'.");
    }
    return question;
}

Result<QJsonObject> runPivot(const QStringList& arguments)
{
    const Result<PivotQuestion> question = questionOf(arguments);
    if (!question)
        return tl::unexpected(question.error());
    const auto poses = posesOf(question->path);
    if (!poses)
        return tl::unexpected(poses.error());
    auto object = question->p_S_ahead ? describeAxis(*poses, *question->p_S_ahead)
                                      : describeTip(*poses, question->limit);
    if (!object)
        return fail(object.error().code, question->path.toStdString() + " does not tell the "
                                             + (question->p_S_ahead ? "axis" : "tip") + ": "
                                             + object.error().detail + ".");
    return object;
}

} // namespace

Command pivotCommand() { return {"pivot", kPivotHelp, runPivot}; }

} // namespace carina::lab
