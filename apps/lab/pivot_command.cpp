#include "apps/lab/pivot_command.h"

#include "apps/lab/csv_table.h"
#include "apps/lab/recorded_stylus.h"
#include "engine/io/json_fields.h"
#include "engine/registration/pivot_calibration.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

namespace carina::lab
{
namespace
{

constexpr std::string_view kPivotHelp =
    R"(pivot FILE|DIR
    Finds the tip of a stylus from its poses while it was swung with its tip in a divot. Poses whose
    tip is further than 3 mm from the divot are left out.
    FILE.igs.mha      a recording with the tool Stylus, or one tool only; where it has the tool
                      Reference too, poses are taken in its frame
    FILE.csv          a line of column names in any order, then one line for each pose:
      tx,ty,tz        the origin of the stylus, mm
      qx,qy,qz,qw     its rotation as a quaternion of any length but 0
    DIR               its files *.txt, each 16 numbers: a 4x4 pose row by row, translation in mm,
                      parted by blanks, commas or line ends
    schema            "carina.pivot/1"
    tip_mm            [x, y, z] of the tip in the frame of the stylus
    pivot_mm          [x, y, z] of the divot in the frame of the poses
    rms_mm            root of the mean squared distance of the tips from the divot
    poses             read and tracked
    outliers          of these, left out
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

Result<QJsonObject> runPivot(const QStringList& arguments)
{
    if (arguments.size() != 1)
        return fail(Errc::OutOfRange, "pivot needs one file or folder of poses.");
    const auto poses = posesOf(arguments[0]);
    if (!poses)
        return tl::unexpected(poses.error());
    const Result<PivotCalibration> pivot = calibratePivot(*poses);
    if (!pivot)
        return fail(pivot.error().code, arguments[0].toStdString() + " does not tell the tip: "
                                            + pivot.error().detail + ".");
    return QJsonObject{{QStringLiteral("schema"), QStringLiteral("carina.pivot/1")},
                       {QStringLiteral("tip_mm"), jsonPoint(pivot->p_SQ)},
                       {QStringLiteral("pivot_mm"), jsonPoint(pivot->p_TQ)},
                       {QStringLiteral("rms_mm"), inMillimetres(metres(pivot->rms))},
                       {QStringLiteral("poses"), static_cast<qint64>(poses->size())},
                       {QStringLiteral("outliers"), pivot->outliers}};
}

} // namespace

Command pivotCommand() { return {"pivot", kPivotHelp, runPivot}; }

} // namespace carina::lab
