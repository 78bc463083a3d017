#include "engine/io/anatomy_set/anatomy_set.h"
#include "tests/engine/io/mesh/surface_files.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <algorithm>

namespace carina::set_corrections_test
{
namespace
{

const AnatomyPart* partNamed(const Anatomy& anatomy, const std::string& name)
{
    const auto found = std::find_if(anatomy.parts.begin(), anatomy.parts.end(),
                                    [&](const AnatomyPart& part) { return part.name == name; });
    return found == anatomy.parts.end() ? nullptr : &*found;
}

SetFrame inches()
{
    SetFrame frame;
    frame.metresPerUnit = 0.0254;
    frame.R_AF << 0, 1, 0, -1, 0, 0, 0, 0, 1;
    return frame;
}

} // namespace

class TestSetCorrections : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_temporary;
    std::filesystem::path m_set;
    std::filesystem::path m_cache;

    Result<LoadedSet> load(const SetReview& review = {}, CacheUse use = CacheUse::Allowed) const
    {
        return loadAnatomySet(m_set, m_cache, {}, use, review);
    }
    [[nodiscard]] std::filesystem::path file() const
    {
        return m_temporary->path().toStdString() + "/corrections.json";
    }
    void write(const std::string& text) const { test::writeFile(file(), text); }

private Q_SLOTS:
    void init()
    {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_set = m_temporary->path().toStdString() + "/Somebody";
        m_cache = m_temporary->path().toStdString() + "/cache";
        test::writeFile(m_set / "Trachea.obj", test::objOf({100.0F, -5.0F, -5.0F, 1300.0F}));
        test::writeFile(m_set / "blob.obj", test::objOf({200.0F, 20.0F, -50.0F, 1100.0F}));
        test::writeFile(m_set / "broken.obj", "v 1 2\n");
    }

    void showsAPersonWhatItTookTheSurfacesFor()
    {
        std::optional<SetDraft> seen;
        QVERIFY(load([&](const SetDraft& draft) {
            seen = draft;
            return SetCorrections{};
        }));
        QVERIFY(seen);
        QCOMPARE(seen->surfaces.size(), std::size_t{2});
        QCOMPARE(seen->surfaces[0].key, std::string{"Trachea.obj: Trachea"});
        QVERIFY(seen->surfaces[0].role == PartRole::Trachea);
        QCOMPARE(seen->surfaces[0].triangles, std::size_t{4});
        QVERIFY(seen->surfaces[1].role == PartRole::Other);
        QVERIFY(seen->frame && seen->frame->metresPerUnit == 1e-3);
        QCOMPARE(seen->faults.size(), std::size_t{1});
        QCOMPARE(seen->faults[0].file, std::string{"broken.obj"});
    }

    void takesSurfacesForWhatThePersonSays()
    {
        const auto loaded = load([](const SetDraft& draft) {
            SetCorrections corrections;
            corrections.roles[draft.surfaces[1].key] = PartRole::LeftLung;
            return corrections;
        });
        QVERIFY(loaded);
        QVERIFY(partNamed(loaded->set.anatomy, "Blob")->role == PartRole::LeftLung);
    }

    void leavesOutWhatThePersonDoesNotWant()
    {
        const auto loaded = load([](const SetDraft& draft) {
            SetCorrections corrections;
            corrections.roles[draft.surfaces[1].key] = std::nullopt;
            return corrections;
        });
        QVERIFY(loaded);
        QVERIFY(partNamed(loaded->set.anatomy, "Blob") == nullptr);
        QCOMPARE(loaded->set.leftOut, std::vector<std::string>{"blob.obj: Blob, as asked for"});
    }

    void asksForTheUnitWhereNoneFits()
    {
        test::writeFile(m_set / "Skull.obj", test::objOf({7000.0F, 0.0F, 0.0F, 60.0F}));
        test::writeFile(m_set / "Trachea.obj", test::objOf({4000.0F, 0.0F, 0.0F, 50.0F}));
        QCOMPARE(load().error().code, Errc::OutOfRange);
        const auto loaded = load([](const SetDraft& draft) {
            SetCorrections corrections;
            if (!draft.frame)
                corrections.frame = SetFrame{2.5e-5, Mat3::Identity()};
            return corrections;
        });
        QVERIFY(loaded);
        const Box box = boundsOf(partNamed(loaded->set.anatomy, "Trachea")->levels[0]);
        QVERIFY((box.size() - Vec3::Constant(0.1)).norm() < 1e-6);
    }

    void turnsTheAxesAsThePersonSays()
    {
        test::writeFile(m_set / "Heart.obj", test::objOf({90.0F, 200.0F, -5.0F, 1300.0F}));
        const auto loaded = load([](const SetDraft& draft) {
            SetCorrections corrections;
            corrections.frame = draft.frame;
            corrections.frame->R_AF << 0, 1, 0, -1, 0, 0, 0, 0, 1; // x anterior, y left
            return corrections;
        });
        QVERIFY(loaded);
        const Box trachea = boundsOf(partNamed(loaded->set.anatomy, "Trachea")->levels[0]);
        const Box heart = boundsOf(partNamed(loaded->set.anatomy, "Heart")->levels[0]);
        QVERIFY(heart.max.y() < trachea.min.y());
    }

    void stopsWhereThePersonDoes()
    {
        const auto loaded = load([](const SetDraft&) { return std::optional<SetCorrections>{}; });
        QCOMPARE(loaded.error().code, Errc::Cancelled);
        QVERIFY(!std::filesystem::exists(m_cache));
    }

    void remembersCorrectionsForTheSameFiles()
    {
        const std::string plain = load()->set.anatomy.contentHash;
        const auto corrected = load(
            [](const SetDraft& draft) {
                SetCorrections corrections;
                corrections.roles[draft.surfaces[1].key] = PartRole::LeftLung;
                return corrections;
            },
            CacheUse::Renewed);
        QVERIFY(corrected->set.anatomy.contentHash != plain);
        const auto again = load();
        QVERIFY(again->fromCache);
        QCOMPARE(again->set.anatomy.contentHash, corrected->set.anatomy.contentHash);
        std::filesystem::copy(m_set, m_set.parent_path() / "Copy");
        m_set = m_set.parent_path() / "Copy";
        const auto renewed = load({}, CacheUse::Renewed);
        QCOMPARE(renewed->set.anatomy.contentHash, corrected->set.anatomy.contentHash);
        QVERIFY(partNamed(renewed->set.anatomy, "Blob")->role == PartRole::LeftLung);
    }

    void showsEarlierCorrectionsAndAddsToThem()
    {
        const auto first = load([](const SetDraft& draft) {
            SetCorrections corrections;
            corrections.roles[draft.surfaces[1].key] = PartRole::LeftLung;
            corrections.frame = SetFrame{2e-3, Mat3::Identity()};
            return corrections;
        });
        QVERIFY(first);
        std::optional<SetDraft> seen;
        const auto second = load(
            [&](const SetDraft& draft) {
                seen = draft;
                SetCorrections corrections;
                corrections.roles[draft.surfaces[0].key] = PartRole::Larynx;
                return corrections;
            },
            CacheUse::Renewed);
        QVERIFY(seen->surfaces[1].role == PartRole::LeftLung);
        QCOMPARE(seen->frame->metresPerUnit, 2e-3);
        QVERIFY(partNamed(second->set.anatomy, "Blob")->role == PartRole::LeftLung);
        QVERIFY(partNamed(second->set.anatomy, "Trachea")->role == PartRole::Larynx);
        QCOMPARE(second->set.frame.metresPerUnit, 2e-3);
    }

    void keepsAllOfThemInAFile()
    {
        SetCorrections written;
        written.roles = {{"a.obj: A", PartRole::Vessel}, {"b.obj: B", std::nullopt}};
        written.frame = inches();
        QVERIFY(writeCorrections(file(), written));
        const auto read = readCorrections(file());
        QVERIFY(read);
        QVERIFY(read->roles == written.roles);
        QVERIFY(std::abs(read->frame->metresPerUnit - 0.0254) < 1e-12);
        QVERIFY(read->frame->R_AF == written.frame->R_AF);
        QVERIFY(writeCorrections(file(), {}));
        QVERIFY(readCorrections(file())->empty());
    }

    void refusesAFileThatSaysSomethingElse_data()
    {
        QTest::addColumn<std::string>("fields");
        QTest::newRow("no such role") << std::string{R"("roles": {"a": "wing"})"};
        QTest::newRow("a role that is no word") << std::string{R"("roles": {"a": 3})"};
        QTest::newRow("a unit of nothing")
            << std::string{R"("unit_mm": 0, "axes": ["left", "posterior", "superior"])"};
        QTest::newRow("a huge unit")
            << std::string{R"("unit_mm": 1e7, "axes": ["left", "posterior", "superior"])"};
        QTest::newRow("a unit without axes") << std::string{R"("unit_mm": 1)"};
        QTest::newRow("axes without a unit")
            << std::string{R"("axes": ["left", "posterior", "superior"])"};
        QTest::newRow("an axis twice")
            << std::string{R"("unit_mm": 1, "axes": ["left", "right", "superior"])"};
        QTest::newRow("two axes") << std::string{R"("unit_mm": 1, "axes": ["left", "posterior"])"};
    }

    void refusesAFileThatSaysSomethingElse()
    {
        QFETCH(std::string, fields);
        write(R"({"schema": "carina.set-corrections/1", )" + fields + "}");
        const auto read = readCorrections(file());
        QVERIFY(!read);
        QCOMPARE(read.error().code, Errc::FileMalformed);
        QVERIFY(read.error().detail.starts_with(file().string()));
    }

    void readsAxesAsTheyAreNamed()
    {
        for (const SetFrame& frame : {inches(), SetFrame{}})
            QVERIFY(axesFromWords(axisWords(frame)) == std::optional{frame.R_AF});
        QVERIFY(!axesFromWords({"left", "posterior", "upward"}));
    }
};

CARINA_TEST(TestSetCorrections)

} // namespace carina::set_corrections_test

#include "tst_set_corrections.moc"
