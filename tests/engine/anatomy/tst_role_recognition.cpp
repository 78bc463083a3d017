#include "engine/anatomy/role_recognition.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace carina::role_recognition_test
{
namespace
{

/// The roles that a group of the anatomy set's manifest may hold.
const std::map<std::string, std::set<PartRole>> kRolesOfGroup{
    {"airway",
     {PartRole::Trachea, PartRole::RightMainBronchus, PartRole::LeftMainBronchus,
      PartRole::BronchialTree}},
    {"larynx", {PartRole::Larynx, PartRole::Hyoid, PartRole::Epiglottis}},
    {"mouth_pharynx",
     {PartRole::Tooth, PartRole::Mucosa, PartRole::Tongue, PartRole::Pharynx, PartRole::Oesophagus,
      PartRole::Muscle, PartRole::Other}},
    {"skull", {PartRole::Skull, PartRole::Mandible}},
    {"spine", {PartRole::Spine}},
    {"thorax", {PartRole::Rib}},
    {"neck_muscle", {PartRole::Muscle, PartRole::Other}},
    {"vessels_heart", {PartRole::Heart, PartRole::Vessel}},
};

} // namespace

class TestRoleRecognition : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void recognisesNames_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("role");
        const auto row = [](const char* name, const char* role) {
            QTest::newRow(name) << QString::fromLatin1(name) << QString::fromLatin1(role);
        };
        row("Trachea", "trachea");
        row("TRACHEA", "trachea");
        row("Left main bronchus", "left_main_bronchus");
        row("Right main bronchus proper", "right_main_bronchus");
        row("Main bronchus", "other");
        row("Superior lingular bronchial tree", "bronchial_tree");
        row("Bronchial branch of arch of aorta", "vessel");
        row("Set of oesophageal branches of thoracic aorta", "vessel");
        row("Left crico-arytenoid", "larynx");
        row("Left thyrohyoid", "muscle");
        row("Left thyrohyoid membrane", "larynx");
        row("Epiglottis", "epiglottis");
        row("Hyo-epiglottic ligament", "larynx");
        row("Thyroid gland", "other");
        row("right_upper_lobe", "right_upper_lobe");
        row("Middle lobe of right lung", "right_middle_lobe");
        row("Lower lobe of left lung", "left_lower_lobe");
        row("LeftLung", "left_lung");
        row("lung.R", "right_lung");
        row("Lungs", "other");
        row("Left upper central secondary incisor tooth", "tooth");
        row("Mandible", "mandible");
        row("Axis", "spine");
        row("Left second costal cartilage", "rib");
        row("Tribal mask", "other");
        row("Esophagus", "oesophagus");
        row("Left genioglossus", "tongue");
        row("Hard palate", "pharynx");
        row("Oral cavity", "pharynx");
        row("Pharyngeal mucosa", "pharynx");
        row("Left palatoglossal arch", "pharynx");
        row("Right palatine tonsil", "pharynx");
        row("Uvula", "pharynx");
        row("Laryngeal mucosa", "laryngeal_mucosa");
        row("Vallecula", "laryngeal_mucosa");
        row("Left aryepiglotticus", "larynx");
        row("Left aryepiglottic fold", "laryngeal_mucosa");
        row("Median glosso-epiglottic fold", "mucosa");
        row("Left vestibular fold", "laryngeal_mucosa");
        row("Left vocal fold", "vocal_fold");
        row("Left vocalis", "larynx");
        row("Lower lip", "mucosa");
        row("Gingiva of lower jaw", "mucosa");
        row("Hyoid bone", "hyoid");
        row("Left greater horn of hyoid", "hyoid");
        row("Thyrohyoid membrane", "larynx");
        row("Left lateral thyrohyoid ligament", "larynx");
        row("Left thyrohyoid", "muscle");
        row("Cranium", "skull");
        row("Heart", "heart");
        row("Aorta", "vessel");
        row("Inferior vena cava", "vessel");
        row("Pulmonary trunk", "vessel");
        row("Diaphragm", "diaphragm");
        row("", "other");
    }

    void recognisesNames()
    {
        QFETCH(QString, name);
        QFETCH(QString, role);
        const PartRole found = recogniseRole({}, name.toStdString());
        QCOMPARE(QString::fromLatin1(roleName(found)), role);
    }

    void recognisesConceptsWithoutAName()
    {
        QVERIFY(recogniseRole("FMA7394", "") == PartRole::Trachea);
        QVERIFY(recogniseRole("FMA52749", "") == PartRole::Hyoid);
        QVERIFY(recogniseRole("FMA68210", "") == PartRole::Other);
        QVERIFY(recogniseRole("FMA68211", "") == PartRole::BronchialTree);
        QVERIFY(recogniseRole("FMA68233", "") == PartRole::BronchialTree);
        QVERIFY(recogniseRole("FMA68234", "") == PartRole::Other);
        QVERIFY(recogniseRole("7394", "") == PartRole::Other);
        QVERIFY(recogniseRole("FMA7394x", "") == PartRole::Other);
        QVERIFY(recogniseRole("FMA99999999999999", "") == PartRole::Other);
    }

    void prefersTheConceptToTheName()
    {
        QVERIFY(recogniseRole("FMA7394", "Mandible") == PartRole::Trachea);
        QVERIFY(recogniseRole("FMA1", "Mandible") == PartRole::Mandible);
    }

    void readsTheSideFromANameThatHasOne()
    {
        QVERIFY(sideFromName("Left second rib") == Side::Left);
        QVERIFY(sideFromName("rib_R") == Side::Right);
        QVERIFY(sideFromName("upright bar") == std::nullopt);
        QVERIFY(sideFromName("left and right lung") == std::nullopt);
    }

    void recognisesTheWholeRealSet()
    {
        const auto manifest = test::testData("anatomy/bodyparts3d/MANIFEST.tsv");
        if (!manifest)
            QSKIP("the real anatomy is not here");
        std::ifstream stream{*manifest};
        std::string line;
        std::getline(stream, line);
        int parts = 0;
        int others = 0;
        while (std::getline(stream, line)) {
            std::istringstream cells{line};
            std::string group, file, conceptId, name;
            std::getline(cells, group, '\t');
            std::getline(cells, file, '\t');
            std::getline(cells, conceptId, '\t');
            std::getline(cells, name, '\t');
            const PartRole role = recogniseRole(conceptId, name);
            QVERIFY2(kRolesOfGroup.at(group).contains(role), line.c_str());
            // Where the concept is known, name and concept agree.
            QVERIFY2(recogniseRole(conceptId, "") == PartRole::Other
                         || recogniseRole("", name) == role,
                     line.c_str());
            ++parts;
            if (role == PartRole::Other) {
                ++others;
                qInfo() << "without a role:" << name.c_str();
            }
        }
        QCOMPARE(parts, 358);
        QCOMPARE(others, 4); // submandibular glands, stylohyoid ligaments
    }
};

CARINA_TEST(TestRoleRecognition)

} // namespace carina::role_recognition_test

#include "tst_role_recognition.moc"
