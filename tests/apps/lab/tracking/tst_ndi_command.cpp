#include "apps/lab/commands.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <fstream>

namespace carina::lab::ndi_command_test
{

class NdiCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void printsWhatAConversationTells()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("polaris.txt"));
        std::ofstream{path.toStdString()}
            << "recv:0001 = RESETBE6F\nsent:0002 = TX:0001031A\nrecv:0002 = 0101MISSING"
               "00000031000003A3\n00005A49\nsent:0003 = TX:0001031A\nrecv:0003 = 0101+07003+07110-"
               "00250+00572-021400+009890-158180+0110600000031000003AD\n0000D166\nsent:0004 = "
               "TX:0001031A\nrecv:0004 = 0101MISSING00000031000003A3\n00005A48\n";
        const auto object = ndiCommand().run({QStringLiteral("decode"), path});
        QVERIFY(object);
        QCOMPARE((*object)[QLatin1StringView{"commands"}].toInt(), 3);
        QCOMPARE((*object)[QLatin1StringView{"replies"}].toInt(), 4);
        QCOMPARE((*object)[QLatin1StringView{"crc_errors"}].toInt(), 1);
        QCOMPARE((*object)[QLatin1StringView{"poses"}].toInt(), 1);
        const QJsonObject refused = (*object)[QLatin1StringView{"refused"}].toArray()[0].toObject();
        QCOMPARE(refused[QLatin1StringView{"line"}].toInt(), 8);
        const QJsonObject tool = (*object)[QLatin1StringView{"tools"}].toArray()[0].toObject();
        QCOMPARE(tool[QLatin1StringView{"handle"}].toString(), QStringLiteral("01"));
        QCOMPARE(tool[QLatin1StringView{"sights"}].toObject(),
                 (QJsonObject{{QStringLiteral("missing"), 1}, {QStringLiteral("tracked"), 1}}));
        const QJsonObject pose = tool[QLatin1StringView{"poses"}].toArray()[0].toObject();
        QCOMPARE(pose[QLatin1StringView{"frame"}].toInt(), 0x3AD);
        const QJsonArray p_mm = pose[QLatin1StringView{"p_mm"}].toArray();
        QVERIFY(std::abs(p_mm[0].toDouble() + 214.00) < 1e-6);
        QVERIFY(std::abs(p_mm[1].toDouble() - 98.90) < 1e-6);
        QVERIFY(std::abs(p_mm[2].toDouble() + 1581.80) < 1e-6);
        QVERIFY(std::abs(pose[QLatin1StringView{"error_mm"}].toDouble() - 0.1106) < 1e-6);
        QVERIFY(pose[QLatin1StringView{"time_s"}].isNull());
        QVERIFY((*object)[kAcceptable].toBool());
    }

    void isNotAcceptableWhereNothingIsDecoded()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("polaris.txt"));
        std::ofstream{path.toStdString()} << "sent:0002 = TX:0001031B\nrecv:0002 = OKAYA897\n";
        const auto object = ndiCommand().run({QStringLiteral("decode"), path});
        QVERIFY(object);
        QCOMPARE((*object)[QLatin1StringView{"crc_errors"}].toInt(), 2);
        QVERIFY(!(*object)[kAcceptable].toBool(true));
    }

    void refusesOtherWords()
    {
        for (const QStringList& words : {QStringList{},
                                         {QStringLiteral("decode")},
                                         {QStringLiteral("encode"), QStringLiteral("x")}}) {
            const auto object = ndiCommand().run(words);
            QVERIFY(!object);
            QCOMPARE(object.error().code, Errc::WrongOption);
        }
        const auto missing =
            ndiCommand().run({QStringLiteral("decode"), QStringLiteral("nowhere.txt")});
        QVERIFY(!missing);
        QCOMPARE(missing.error().code, Errc::FileNotFound);
    }
};

CARINA_TEST(NdiCommandTest)

} // namespace carina::lab::ndi_command_test

#include "tst_ndi_command.moc"
