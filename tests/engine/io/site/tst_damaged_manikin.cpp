#include "engine/io/site/manikin_json.h"
#include "tests/engine/io/site/site_sample.h"
#include "tests/support/test_class.h"

#include <QJsonDocument>

#include <random>

namespace carina::damaged_manikin_test
{
namespace
{

std::string textOf(const SiteManikin& manikin)
{
    return QJsonDocument{jsonManikin(manikin)}.toJson().toStdString();
}

/// Whether the reader either refuses a text, with a reason, or gives a manikin that it reads again.
bool answersSoundly(const std::string& text)
{
    const auto object = jsonObjectIn(text);
    if (!object)
        return !object.error().detail.empty();
    std::optional<Error> fault;
    JsonFields fields{*object, fault};
    const SiteManikin manikin = readManikin(fields);
    if (fault)
        return !fault->detail.empty();
    for (const TouchedAirwayPlace& touched : manikin.airway)
        if (!touched.p_MQ.allFinite() || std::size_t(touched.place) >= kAirwayPlaces.size())
            return false;
    const QJsonObject written = jsonManikin(manikin);
    JsonFields again{written, fault};
    return readManikin(again).airway.size() == manikin.airway.size() && !fault;
}

} // namespace

/// The reader of a site's manikin on damaged bytes: seeded, so that a failure can be had again.
class TestDamagedManikin : public QObject
{
    Q_OBJECT

private:
    const std::string m_sound = textOf(test::wholeSite().manikin);

private Q_SLOTS:
    void readsTheUndamagedText() { QVERIFY(answersSoundly(m_sound)); }

    void staysSoundWhereBytesAreChanged()
    {
        std::mt19937 random{7};
        for (int round = 0; round < 6000; ++round) {
            std::string text = m_sound;
            const int changes = round % 3 == 0 ? 1 : round % 3 == 1 ? 3 : 30;
            for (int i = 0; i < changes; ++i)
                text[random() % text.size()] = static_cast<char>(random() % 256);
            QVERIFY2(answersSoundly(text), text.c_str());
        }
    }

    void staysSoundWherePartsAreMissingOrTwice()
    {
        std::mt19937 random{9};
        for (int round = 0; round < 3000; ++round) {
            std::string text = m_sound;
            const std::size_t from = random() % text.size();
            const std::size_t length = random() % 40;
            if (round % 2 == 0)
                text.erase(from, length);
            else
                text.insert(random() % text.size(), m_sound.substr(from, length));
            QVERIFY2(answersSoundly(text), text.c_str());
        }
    }
};

CARINA_TEST(TestDamagedManikin)

} // namespace carina::damaged_manikin_test

#include "tst_damaged_manikin.moc"
