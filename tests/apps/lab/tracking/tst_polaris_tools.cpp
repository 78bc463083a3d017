#include "apps/lab/tracking/polaris_tools.h"

#include "apps/lab/commands.h"
#include "tests/evaluation/polaris/rom_file.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <span>

namespace carina::lab::polaris_tools_test
{
namespace
{

const std::vector<NamedTool> kNamed{{"head", ToolRole::Head}, {"stylus", ToolRole::Stylus}};

QString written(const QTemporaryDir& folder, const char* name, const std::string& bytes)
{
    QFile file{folder.filePath(QString::fromLatin1(name))};
    if (!file.open(QIODevice::WriteOnly))
        return {};
    file.write(QByteArray::fromStdString(bytes));
    return file.fileName();
}

Result<PolarisTools> toolsWith(const QString& files)
{
    const auto words = Words::read(polarisCommand(), {QStringLiteral("DIR")});
    return polarisTools(*words, kNamed, files);
}

} // namespace

class PolarisToolsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aToolHasWhatItsFileSays()
    {
        const QTemporaryDir folder;
        const test::RomFile rom{.partNumber = "8700340"};
        const QString file = written(folder, "pointer.rom", rom.bytes());
        const auto tools = toolsWith(QStringLiteral("stylus=%1").arg(file));
        QVERIFY2(tools, tools ? "" : tools.error().detail.c_str());
        QCOMPARE(tools->described.size(), std::size_t{2});
        QCOMPARE(tools->described[1].name, std::string{"stylus"});
        QCOMPARE(tools->described[1].role, ToolRole::Stylus);
        const std::string bytes = rom.bytes();
        QVERIFY(std::ranges::equal(tools->described[1].definition->bytes(),
                                   std::as_bytes(std::span{bytes})));
        const PolarisTool& known = tools->known.at("stylus");
        QCOMPARE(known.partNumber, std::string{"8700340"});
        QCOMPARE(known.markers.size(), rom.markers_mm.size());
        for (std::size_t i = 0; i < known.markers.size(); ++i)
            QVERIFY(known.markers[i].p_mm == rom.markers_mm[i]);
        QVERIFY(!haveSameMarkers(known, tools->known.at("head")));
    }

    void refusesWhatIsNoToolOfItsOwn()
    {
        const QTemporaryDir folder;
        const QString file = written(folder, "pointer.rom", test::RomFile{}.bytes());
        const test::RomFile needle{.markers_mm = {{0, 0, 87}, {0.3, 0, 137}, {0, 0.3, 192}}};
        const QString line = written(folder, "needle.rom", needle.bytes());
        for (const QString& files :
             {QStringLiteral("bougie=%1").arg(file), QStringLiteral("stylus"),
              QStringLiteral("stylus="), QStringLiteral("stylus=%1").arg(line),
              QStringLiteral("head=%1,stylus=%1").arg(file)}) {
            const auto tools = toolsWith(files);
            QVERIFY2(!tools, qPrintable(files));
            QCOMPARE(tools.error().code, Errc::WrongOption);
        }
    }

    void saysWhatIsWrongWithAFile()
    {
        const QTemporaryDir folder;
        const QString cut = written(folder, "cut.rom", test::RomFile{}.bytes().substr(0, 700));
        const auto tools = toolsWith(QStringLiteral("stylus=%1").arg(cut));
        QVERIFY(!tools);
        QCOMPARE(tools.error().code, Errc::FileMalformed);
        QCOMPARE(tools.error().detail, cut.toStdString() + ": it has 700 bytes, not 752");
        const auto absent = toolsWith(
            QStringLiteral("stylus=%1").arg(folder.filePath(QStringLiteral("absent.rom"))));
        QVERIFY(!absent);
        QCOMPARE(absent.error().code, Errc::FileNotFound);
    }
};

CARINA_TEST(PolarisToolsTest)

} // namespace carina::lab::polaris_tools_test

#include "tst_polaris_tools.moc"
