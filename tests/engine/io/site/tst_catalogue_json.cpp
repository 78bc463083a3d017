#include "engine/io/site/catalogue_json.h"

#include "tests/support/test_class.h"

#include <QJsonDocument>

namespace carina::catalogue_json_test
{
namespace
{

constexpr double kExact = 1e-15; // m

const std::string kText = R"({"name": "Thorax", "anatomy": "ab12",
 "landmarks": [{"name": "Notch", "p_AQ_mm": [0, -60.5, 36]},
               {"name": "Côte gauche", "p_AQ_mm": [80, -123, -111]},
               {"name": "Tip", "p_AQ_mm": [0, -131.5, -131.25]}]})";

std::string replaced(const std::string& from, const std::string& to)
{
    std::string text = kText;
    return text.replace(text.find(from), from.size(), to);
}

Result<LandmarkCatalogue> read(const QJsonObject& object)
{
    std::optional<Error> fault;
    JsonFields fields{object, fault};
    LandmarkCatalogue catalogue = readCatalogue(fields);
    if (fault)
        return tl::unexpected(*fault);
    return catalogue;
}

Result<LandmarkCatalogue> readText(const std::string& text)
{
    return read(QJsonDocument::fromJson(QByteArray::fromStdString(text)).object());
}

} // namespace

class TestCatalogueJson : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsMillimetresAsMetres()
    {
        const auto catalogue = readText(kText);
        QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().detail.c_str());
        QCOMPARE(catalogue->name, std::string{"Thorax"});
        QCOMPARE(catalogue->anatomy, std::string{"ab12"});
        QCOMPARE(catalogue->landmarks.size(), 3U);
        QCOMPARE(catalogue->landmarks[1].name, std::string{"Côte gauche"});
        QVERIFY((catalogue->landmarks[0].p_AQ - Vec3{0.0, -0.0605, 0.036}).norm() < kExact);
        QVERIFY((catalogue->landmarks[2].p_AQ - Vec3{0.0, -0.1315, -0.13125}).norm() < kExact);
    }

    void readsBackWhatItWrote_data()
    {
        QTest::addColumn<std::string>("anatomy");
        QTest::newRow("of a patient") << std::string{"0f3a"};
        QTest::newRow("of none") << std::string{};
    }

    void readsBackWhatItWrote()
    {
        QFETCH(std::string, anatomy);
        const LandmarkCatalogue catalogue = ribCageCatalogue(metres(1.75), anatomy);
        const auto back = read(jsonCatalogue(catalogue));
        QVERIFY(back.has_value());
        QCOMPARE(back->name, catalogue.name);
        QCOMPARE(back->anatomy, anatomy);
        QCOMPARE(back->landmarks.size(), catalogue.landmarks.size());
        for (std::size_t i = 0; i < catalogue.landmarks.size(); ++i) {
            QCOMPARE(back->landmarks[i].name, catalogue.landmarks[i].name);
            QVERIFY((back->landmarks[i].p_AQ - catalogue.landmarks[i].p_AQ).norm() < kExact);
        }
    }

    void saysWhereACatalogueIsAtFault_data()
    {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<QString>("fault");
        const auto row = [](const char* name, const std::string& text, const char* fault) {
            QTest::newRow(name) << text << QString::fromLatin1(fault);
        };
        row("no name", replaced("\"Thorax\"", "7"), "name: a text is expected");
        row("an unnamed landmark", replaced("\"Notch\"", "\"\""),
            "landmarks[0].name: a text is expected");
        row("no list", replaced("\"landmarks\": [", "\"landmarks\": {\"a\": [").append("}"),
            "landmarks: a list is expected");
        row("no object in the list", replaced("[{\"name\": \"Notch\"", "[5, {\"name\": \"Notch\""),
            "landmarks[0]: an object is expected");
        row("two numbers", replaced("[0, -60.5, 36]", "[0, -60.5]"),
            "landmarks[0].p_AQ_mm: three numbers are expected, in millimetres");
        row("four numbers", replaced("-111]", "-111, 0]"), "landmarks[1].p_AQ_mm: three numbers");
        row("a word for a number", replaced("36]", "\"36\"]"), "landmarks[0].p_AQ_mm");
        row("null for a number", replaced("36]", "null]"), "landmarks[0].p_AQ_mm");
        row("a kilometre", replaced("36]", "1e6]"), "landmarks[0].p_AQ_mm");
        row("in another unit", replaced("p_AQ_mm", "p_AQ_m"),
            "landmarks[0].p_AQ_m: this key is not known");
        row("a misspelled key", replaced("\"anatomy\"", "\"anatomie\""),
            "anatomie: this key is not known");
        row("twice the same name", replaced("Tip", "Notch"), "landmarks: \"Notch\" is there twice");
    }

    void saysWhereACatalogueIsAtFault()
    {
        QFETCH(std::string, text);
        QFETCH(QString, fault);
        const auto catalogue = readText(text);
        QVERIFY(!catalogue);
        const QString detail = QString::fromStdString(catalogue.error().detail);
        QCOMPARE(catalogue.error().code, Errc::FileMalformed);
        QVERIFY2(detail.contains(fault), qPrintable(detail));
    }
};

CARINA_TEST(TestCatalogueJson)

} // namespace carina::catalogue_json_test

#include "tst_catalogue_json.moc"
