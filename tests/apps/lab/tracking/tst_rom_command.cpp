#include "apps/lab/commands.h"
#include "engine/tracking/ndi/tool_definition.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <cmath>
#include <cstring>
#include <numeric>

namespace carina::lab::rom_command_test
{
namespace
{

constexpr qsizetype kChecksumAt = 4;
constexpr qsizetype kSummedFrom = 6;
constexpr qsizetype kUnknownAt = 700;

QByteArray bytesIn(const QString& path)
{
    QFile file{path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
}

quint16 sumOf(const QByteArray& bytes)
{
    return static_cast<quint16>(
        std::accumulate(bytes.begin() + kSummedFrom, bytes.end(), 0U,
                        [](unsigned sum, char each) { return sum + quint8(each); }));
}

quint16 statedSumOf(const QByteArray& bytes)
{
    return static_cast<quint16>(quint8(bytes[kChecksumAt]) | quint8(bytes[kChecksumAt + 1]) << 8U);
}

template <class Number> Number numberAt(const QByteArray& bytes, qsizetype at)
{
    Number number{};
    std::memcpy(&number, bytes.constData() + at, sizeof number);
    return number;
}

/// The text of an error; empty where there is none.
template <class Value> std::string detailOf(const Result<Value>& result)
{
    return result ? std::string{} : result.error().detail;
}

/// A folder with a pointer of four markers; it has a byte that nobody knows the meaning of.
struct RomFolder {
    QTemporaryDir folder;
    QString old = folder.filePath(QStringLiteral("old.rom"));
    QString saved = folder.filePath(QStringLiteral("new.rom"));

    RomFolder()
    {
        const std::vector<ToolMarker> markers{
            {{0, 0, 0}}, {{0, 0, 0.05}}, {{0, 0.025, 0.1}}, {{0, -0.025, 0.135}}};
        const auto tool = NdiToolDefinition::make(
            NdiToolDefinition::Kind::Pointer,
            Probe{.markers = markers, .fewest = 3, .largestMisfit = millimetres(0.75)}, "NDI",
            "8700340");
        QByteArray bytes{reinterpret_cast<const char*>(tool->bytes().data()),
                         qsizetype(tool->bytes().size())};
        bytes[kUnknownAt] = 0x5A;
        const quint16 sum = sumOf(bytes);
        bytes[kChecksumAt] = static_cast<char>(sum);
        bytes[kChecksumAt + 1] = static_cast<char>(sum >> 8U);
        QFile file{old};
        if (file.open(QIODevice::WriteOnly))
            file.write(bytes);
    }

    [[nodiscard]] Result<QJsonObject> change(const QStringList& changes) const
    {
        QStringList words{old};
        for (const QString& each : changes)
            words += QStringList{QStringLiteral("--set"), each};
        return romCommand().run(words + QStringList{QStringLiteral("--save"), saved});
    }
    [[nodiscard]] QStringList files() const
    {
        return QDir{folder.path()}.entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }
};

QStringList newOf(const QStringList& markers)
{
    QStringList words{QStringLiteral("--new")};
    for (const QString& each : markers)
        words += QStringList{QStringLiteral("--marker"), each};
    return words;
}

const QStringList kTriangle{QStringLiteral("-50,0,0"), QStringLiteral("0,80,0"),
                            QStringLiteral("30,0,10,0,0,2")};

} // namespace

class RomCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Where each field stands is known from files of NDI (see tool_definition).
    void changesOneFieldAndTheChecksum_data()
    {
        QTest::addColumn<QString>("change");
        QTest::addColumn<int>("from");
        QTest::addColumn<int>("until");
        const auto row = [](const char* change, int from, int until) {
            QTest::newRow(change) << QString::fromLatin1(change) << from << until;
        };
        row("kind=reference", 15, 16);
        row("largest_angle_deg=60", 24, 28);
        row("fewest_markers=4", 32, 36);
        row("largest_error_mm=0.5", 36, 40);
        row("smallest_spread_mm=25", 64, 68);
        row("maker=Carina", 580, 592);
        row("part_number=A = B", 592, 612);
    }

    void changesOneFieldAndTheChecksum()
    {
        QFETCH(QString, change);
        QFETCH(int, from);
        QFETCH(int, until);
        const RomFolder rom;
        const auto printed = rom.change({change});
        QVERIFY2(printed.has_value(), detailOf(printed).c_str());
        const QByteArray before = bytesIn(rom.old);
        const QByteArray after = bytesIn(rom.saved);
        QCOMPARE(after.size(), qsizetype(752));
        QVERIFY(before.mid(from, until - from) != after.mid(from, until - from));
        QCOMPARE(statedSumOf(after), sumOf(after));
        for (qsizetype at = 0; at < after.size(); ++at)
            QVERIFY2(before[at] == after[at] || (at >= from && at < until)
                         || (at >= kChecksumAt && at < kSummedFrom),
                     qPrintable(QString::number(at)));

        auto first = romCommand().run({rom.old});
        auto again = romCommand().run({rom.saved});
        QVERIFY(first && again);
        QCOMPARE(*again, *printed);
        const QString key = change.left(change.indexOf(QLatin1Char('=')));
        const QString value = change.mid(key.size() + 1);
        bool isNumber = false;
        const double number = value.toDouble(&isNumber);
        if (isNumber)
            QVERIFY(std::abs(again->value(key).toDouble() - number) < 1e-9);
        else
            QCOMPARE(again->value(key).toString(), value);
        for (const QString& other : {key, QStringLiteral("file")}) {
            first->remove(other);
            again->remove(other);
        }
        QCOMPARE(*again, *first);
    }

    void changesSeveralFields()
    {
        const RomFolder rom;
        QVERIFY(rom.change({QStringLiteral("maker="), QStringLiteral("largest_error_mm=1.5"),
                            QStringLiteral("smallest_spread_mm=0")}));
        const QByteArray after = bytesIn(rom.saved);
        QCOMPARE(after.mid(580, 12), QByteArray(12, '\0'));
        QCOMPARE(numberAt<float>(after, 36), 1.5F);
        QCOMPARE(numberAt<float>(after, 64), 0.0F);
        QCOMPARE(after[kUnknownAt], char{0x5A});
    }

    void refusesWhatNoPoseCanFollow_data()
    {
        QTest::addColumn<QString>("change");
        for (const char* change : {"fewest_markers=2",
                                   "fewest_markers=5",
                                   "fewest_markers=3.5",
                                   "largest_error_mm=0",
                                   "largest_error_mm=-1",
                                   "largest_error_mm=nan",
                                   "largest_error_mm=101",
                                   "largest_angle_deg=0",
                                   "largest_angle_deg=60.5",
                                   "largest_angle_deg=181",
                                   "smallest_spread_mm=-1",
                                   "smallest_spread_mm=inf",
                                   "maker=longer than 12",
                                   "maker=M\xC3\xBCller",
                                   "part_number=123456789012345678901",
                                   "kind=tube",
                                   "kind=",
                                   "colour=red",
                                   "part_number",
                                   "markers=3",
                                   "=3"})
            QTest::newRow(change) << QString::fromUtf8(change);
    }

    void refusesWhatNoPoseCanFollow()
    {
        QFETCH(QString, change);
        const RomFolder rom;
        const QByteArray before = bytesIn(rom.old);
        const auto refused = rom.change({QStringLiteral("maker=Carina"), change});
        QVERIFY(!refused);
        QVERIFY(!refused.error().detail.empty());
        QCOMPARE(rom.files(), QStringList{QStringLiteral("old.rom")}); // no half of one, either
        QCOMPARE(bytesIn(rom.old), before);
    }

    void writesOverNoFile()
    {
        const RomFolder rom;
        const QByteArray before = bytesIn(rom.old);
        const auto refused =
            romCommand().run({rom.old, QStringLiteral("--set"), QStringLiteral("maker=Carina"),
                              QStringLiteral("--save"), rom.old});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, Errc::FileUnwritable);
        QCOMPARE(bytesIn(rom.old), before);
    }

    void saysWhichDefinitionIsDamaged()
    {
        const RomFolder rom;
        QFile file{rom.old};
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.seek(100));
        file.write("x");
        file.close();
        const auto refused = rom.change({QStringLiteral("maker=Carina")});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, Errc::FileMalformed);
        QVERIFY(QString::fromStdString(refused.error().detail).startsWith(rom.old));
        QCOMPARE(rom.files(), QStringList{QStringLiteral("old.rom")});
    }

    void makesADefinition()
    {
        const RomFolder rom;
        const auto made =
            romCommand().run(newOf(kTriangle)
                             + QStringList{QStringLiteral("--set"), QStringLiteral("kind=pointer"),
                                           QStringLiteral("--set"), QStringLiteral("part_number=1"),
                                           QStringLiteral("--save"), rom.saved});
        QVERIFY2(made.has_value(), detailOf(made).c_str());
        const QByteArray bytes = bytesIn(rom.saved);
        QCOMPARE(numberAt<quint32>(bytes, 28), 3U);
        QCOMPARE(bytes[15], char{2});
        QCOMPARE(numberAt<float>(bytes, 72), -50.0F); // x of the first
        QCOMPARE(numberAt<float>(bytes, 88), 80.0F);  // y of the second
        QCOMPARE(numberAt<float>(bytes, 96), 30.0F);  // x of the third
        QCOMPARE(numberAt<float>(bytes, 344), 1.0F);  // z of its normal
        QCOMPARE(statedSumOf(bytes), sumOf(bytes));
        const auto read = romCommand().run({rom.saved});
        QVERIFY(read);
        QCOMPARE(*read, *made);
        const QJsonArray markers = read->value(QLatin1StringView{"markers"}).toArray();
        QVERIFY(markers[0].toObject().value(QLatin1StringView{"normal"}).isNull());
    }

    void refusesMarkersThatMakeNoTool_data()
    {
        QTest::addColumn<QStringList>("markers");
        const auto row = [](const char* name, const QStringList& markers) {
            QTest::newRow(name) << markers;
        };
        row("none", {});
        row("two", kTriangle.mid(1));
        row("on one line",
            {QStringLiteral("0,0,0"), QStringLiteral("50,0,0"), QStringLiteral("90,0,0")});
        row("far away", kTriangle + QStringList{QStringLiteral("2001,0,0")});
        row("two coordinates", kTriangle + QStringList{QStringLiteral("20,0")});
        row("a word", kTriangle + QStringList{QStringLiteral("20,0,up")});
        row("not a number", kTriangle + QStringList{QStringLiteral("20,0,nan")});
    }

    void refusesMarkersThatMakeNoTool()
    {
        QFETCH(QStringList, markers);
        const RomFolder rom;
        QVERIFY(
            !romCommand().run(newOf(markers) + QStringList{QStringLiteral("--save"), rom.saved}));
        QCOMPARE(rom.files(), QStringList{QStringLiteral("old.rom")});
    }

    void refusesWordsThatDoNotGoTogether()
    {
        const RomFolder rom;
        const QStringList save{QStringLiteral("--save"), rom.saved};
        QVERIFY(!romCommand().run({}));
        QVERIFY(!romCommand().run(save));
        QVERIFY(!romCommand().run(newOf(kTriangle)));
        QVERIFY(!romCommand().run(newOf(kTriangle) + QStringList{rom.old} + save));
        QVERIFY(!romCommand().run({rom.old, QStringLiteral("--set"), QStringLiteral("maker=A")}));
        QVERIFY(!romCommand().run(
            QStringList{rom.old, QStringLiteral("--marker"), kTriangle.front()} + save));
        QCOMPARE(rom.files(), QStringList{QStringLiteral("old.rom")});
    }
};

CARINA_TEST(RomCommandTest)

} // namespace carina::lab::rom_command_test

#include "tst_rom_command.moc"
