#include "engine/io/site/site_file.h"

#include "engine/io/site/manikin_json.h"

#include "tests/engine/io/mesh/surface_files.h"
#include "tests/engine/io/site/site_sample.h"
#include "tests/engine/io/site/site_text.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QTemporaryDir>

#include <limits>

namespace carina::site_file_test
{
namespace
{

constexpr double kExact = 1e-15;    // m, and as coefficients of a rotation
constexpr double kRelative = 1e-12; // of a covariance's largest entry

bool near(double a, double b) { return std::abs(a - b) < kExact; }

bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < kExact; }

bool near(const RigidTransform& a, const RigidTransform& b)
{
    return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < kExact;
}

template <class Matrix> bool alike(const Matrix& a, const Matrix& b)
{
    return (a - b).cwiseAbs().maxCoeff() <= kRelative * b.cwiseAbs().maxCoeff();
}

} // namespace

class TestSiteFile : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::filesystem::path path() const
    {
        return (m_folder.path() + QStringLiteral("/site.json")).toStdString();
    }
    QByteArray bytes() const
    {
        QFile file{QString::fromStdString(path().string())};
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
    }
    /// A site as the file gives it back.
    Result<Site> kept(const Site& site) const
    {
        const auto written = writeSiteFile(path(), site);
        return written ? readSiteFile(path()) : tl::unexpected(written.error());
    }

private Q_SLOTS:
    void readsBackTrackerAndStyluses()
    {
        const Site site = test::wholeSite();
        const auto back = kept(site);
        QVERIFY2(back.has_value(), back ? "" : back.error().detail.c_str());
        QCOMPARE(back->step, SiteStep::Verify);
        QCOMPARE(back->operatorName, site.operatorName);
        QCOMPARE(back->tracker, site.tracker);
        QCOMPARE(back->styluses.size(), 2U);
        for (std::size_t i = 0; i < 2; ++i) {
            const StylusTip& tip = back->styluses[i];
            QVERIFY(near(tip.p_SQ, site.styluses[i].p_SQ));
            QVERIFY(near(tip.rms, site.styluses[i].rms));
            QCOMPARE(tip.calibratedAt, site.styluses[i].calibratedAt);
            QCOMPARE(tip.tool, site.styluses[i].tool);
            QVERIFY(alike(tip.covariance_S, site.styluses[i].covariance_S));
            QCOMPARE(tip.poses, site.styluses[i].poses);
            QCOMPARE(tip.outliers, site.styluses[i].outliers);
        }
        QVERIFY(near(back->styluses[0].axis->axis_S, site.styluses[0].axis->axis_S));
        QVERIFY(near(back->styluses[0].axis->wobble.si, degrees(0.25).si));
        QCOMPARE(back->styluses[0].axis->calibratedAt, site.styluses[0].axis->calibratedAt);
        QVERIFY(!back->styluses[1].axis);
    }

    void readsBackLandmarksAndTouches()
    {
        const Site site = test::wholeSite();
        const auto back = kept(site);
        QVERIFY(back.has_value());
        QCOMPARE(back->patient, site.patient);
        QCOMPARE(back->catalogue->anatomy, site.catalogue->anatomy);
        QCOMPARE(back->catalogue->landmarks.size(), 4U);
        QCOMPARE(back->touched.size(), 4U);
        for (std::size_t i = 0; i < 4; ++i) {
            QCOMPARE(back->touched[i].landmark, site.touched[i].landmark);
            QVERIFY(near(back->touched[i].p_TQ, site.touched[i].p_TQ));
            QVERIFY(near(back->touched[i].spread, site.touched[i].spread));
            QVERIFY(near(RigidTransform{back->touched[i].q_TS, Vec3::Zero()},
                         RigidTransform{site.touched[i].q_TS, Vec3::Zero()}));
            QVERIFY(back->touched[i].stale == site.touched[i].stale);
            QCOMPARE(back->touched[i].isFitted, i == 1);
            QCOMPARE(back->touched[i].seenError.has_value(), i == 3);
        }
    }

    /// Files of before do not say how well the tracker saw a touch.
    void readsBackHowWellTheTrackerSawATouch()
    {
        const auto back = kept(test::wholeSite());
        QVERIFY(back && near(*back->touched[3].seenError, 0.63e-3));
        QVERIFY(bytes().contains("\"seen_error_mm\": 0.6"));
        test::writeFile(path(), test::touchedWith(", 'seen_error_mm': 1.25"));
        QVERIFY(near(*readSiteFile(path())->touched[0].seenError, 1.25e-3));
        test::writeFile(path(), test::touchedWith({}));
        const auto before = readSiteFile(path());
        QVERIFY(before && !before->touched[0].seenError);
    }

    void readsBackTheRegistration()
    {
        const Site site = test::wholeSite();
        const auto back = kept(site);
        QVERIFY(back && back->registration);
        const SiteRegistration& was = *site.registration;
        const SiteRegistration& is = *back->registration;
        QVERIFY(near(is.X_AM, was.X_AM) && near(is.X_AT, was.X_AT));
        QVERIFY(near(*is.X_JM, *was.X_JM) && near(*is.X_BM, *was.X_BM));
        QVERIFY(near(is.rms, was.rms) && near(is.fle, was.fle));
        QCOMPARE(is.degrees, was.degrees);
        QCOMPARE(is.pooled, 2);
        QCOMPARE(is.disagreeing, 1);
        QVERIFY(alike(is.covariance_A, was.covariance_A));
        QCOMPARE(is.residuals.size(), 2U);
        QCOMPARE(is.residuals[1].landmark, was.residuals[1].landmark);
        QVERIFY(near(is.residuals[1].residual, 0.9e-3));
        QVERIFY(near(*is.residuals[0].leftOut, 0.8e-3) && !is.residuals[1].leftOut);
        QCOMPARE(is.madeAt, was.madeAt);
        QCOMPARE(is.operatorName, was.operatorName);
        QVERIFY(is.stale == StaleCause::Touches);
    }

    void readsBackEarlierLocalisations()
    {
        const auto back = kept(test::wholeSite());
        QVERIFY(back.has_value());
        QCOMPARE(back->localisations.size(), 2U);
        const SiteLocalisation& first = back->localisations[0];
        QVERIFY(near(first.rms, 1.3e-3) && near(back->localisations[1].rms, 0.9e-3));
        QCOMPARE(first.degrees, 18.0);
        QCOMPARE(first.at, std::string{"2004-02-28T09:30:00Z"});
        QCOMPARE(first.operatorName, std::string{"M. Keller"});
        QVERIFY(back->localisations[1].at.empty() && back->localisations[1].operatorName.empty());
    }

    /// A file of the second version has no localisations, and no touch of it is known to be fitted.
    void readsAFileOfTheSecondVersion()
    {
        test::writeFile(path(),
                        test::siteWith(test::kCatalogue + ", 'touched': [" + test::touched("b")
                                           + "], " + test::registration("[0, 1, 0, 6]", "0.25"),
                                       "carina.site/2"));
        const auto site = readSiteFile(path());
        QVERIFY2(site.has_value(), site ? "" : site.error().detail.c_str());
        QVERIFY(site->localisations.empty() && !site->touched[0].isFitted);
        QCOMPARE(site->registration->pooled, 0);
    }

    void readsBackSwabAndRelays()
    {
        const Site site = test::wholeSite();
        const auto back = kept(site);
        QVERIFY(back && back->registration && back->registration->swab);
        const SiteSwab& swab = *back->registration->swab;
        QCOMPARE(swab.surface, std::string{"Left fifth rib"});
        QCOMPARE(swab.points, 120);
        QCOMPARE(swab.outliers, 3);
        QVERIFY(near(swab.startRms, 1.4e-3) && near(swab.rms, 0.4e-3) && near(swab.moved, 2.5e-3));
        const auto& relays = back->registration->relays;
        QCOMPARE(relays.size(), 2U);
        QCOMPARE(relays[0].at, std::string{"2004-03-28T08:00:00Z"});
        QCOMPARE(relays[0].operatorName, std::string{"A. Frei"});
        QCOMPARE(relays[1].landmarks, 4);
        QVERIFY(near(relays[1].rms, 0.7e-3) && relays[1].operatorName.empty());
    }

    void readsBackVerificationAndDisplay()
    {
        const Site site = test::wholeSite();
        const auto back = kept(site);
        QVERIFY(back && back->verification && back->display);
        const SiteVerification& is = *back->verification;
        QCOMPARE(is.verdict, Verdict::NotGood);
        QCOMPARE(is.at, site.verification->at);
        QCOMPARE(is.operatorName, site.verification->operatorName);
        QVERIFY(is.stale == StaleCause::Fit);
        QCOMPARE(is.points.size(), 2U);
        for (std::size_t i = 0; i < 2; ++i) {
            const VerifiedPoint& was = site.verification->points[i];
            QCOMPARE(is.points[i].name, was.name);
            QVERIFY(near(is.points[i].p_AQ, was.p_AQ) && near(is.points[i].p_TQ, was.p_TQ));
            QVERIFY(near(is.points[i].error, was.error) && near(is.points[i].bound, was.bound));
        }
        QVERIFY(near(back->display->p_HDl, site.display->p_HDl));
        QVERIFY(near(back->display->p_HDr, site.display->p_HDr));
        QVERIFY(near(back->display->p_HQ_screenCentre, site.display->p_HQ_screenCentre));
        QVERIFY(near(back->display->screenWidth, 0.8) && near(back->display->screenHeight, 0.45));
    }

    void readsBackASiteThatIsJustBegun()
    {
        const auto back = kept(Site{});
        QVERIFY(back.has_value());
        QCOMPARE(back->step, SiteStep::Tracker);
        QVERIFY(back->tracker.empty() && back->operatorName.empty());
        QVERIFY(back->touched.empty() && back->styluses.empty());
        QVERIFY(!back->catalogue && !back->registration && !back->verification && !back->display);
    }

    void readsBackEveryWordOfAState()
    {
        for (int step = 0; step <= int(SiteStep::Tools); ++step) {
            const auto back = kept({.step = static_cast<SiteStep>(step)});
            QVERIFY(back.has_value());
            QCOMPARE(int(back->step), step);
        }
        for (int cause = 0; cause <= int(StaleCause::Fit); ++cause) {
            Site site = test::wholeSite();
            site.registration->stale = static_cast<StaleCause>(cause);
            QCOMPARE(int(*kept(site)->registration->stale), cause);
        }
        for (int verdict = 0; verdict <= int(Verdict::NotGood); ++verdict) {
            Site site = test::wholeSite();
            site.verification->verdict = static_cast<Verdict>(verdict);
            QCOMPARE(int(kept(site)->verification->verdict), verdict);
        }
    }

    void readsWhatAPersonWrote()
    {
        test::writeFile(path(),
                        test::siteWith(test::kCatalogue + ", 'touched': [" + test::touched("b")
                                       + "], " + test::registration("[0, 1, 0, 6]", "0.25")));
        const auto site = readSiteFile(path());
        QVERIFY2(site.has_value(), site ? "" : site.error().detail.c_str());
        QCOMPARE(site->step, SiteStep::Touch);
        QVERIFY(near(site->touched[0].p_TQ, {0.001, 0.002, 0.003}));
        QVERIFY(near(site->registration->X_AM, RigidTransform::translation({.005, .006, .007})));
        QVERIFY(!site->registration->X_JM && !site->registration->stale);
        QCOMPARE(site->registration->degrees, 0.0);
    }

    /// One stylus without a tool's name, a fit without its error, and no verification.
    void readsAFileOfTheVersionBefore()
    {
        test::writeFile(path(), test::siteWith("'stylus': " + test::stylus("0.3", "2004-03-27")
                                                   + ", " + test::kCatalogue + ", 'touched': ["
                                                   + test::touched("c") + "], "
                                                   + test::registration("[0, 1, 0, 6]", "0.25"),
                                               "carina.site/1"));
        const auto site = readSiteFile(path());
        QVERIFY2(site.has_value(), site ? "" : site.error().detail.c_str());
        QVERIFY(near(site->stylus("any tool")->p_SQ, {0.0, 0.0, 0.001}));
        QVERIFY(site->touched[0].q_TS.isApprox(Quat::Identity()));
        QVERIFY(site->registration->covariance_A.isZero());
        QVERIFY(site->registration->madeAt.empty() && !site->verification);
        QVERIFY(writeSiteFile(path(), *site));
        QVERIFY(bytes().contains("carina.site/6"));
        QVERIFY(readSiteFile(path()).has_value());
    }

    void readsAFileWithoutAManikin()
    {
        test::writeFile(path(), test::siteWith("'tracker': 'simulated'", "carina.site/2"));
        const auto site = readSiteFile(path());
        QVERIFY2(site.has_value(), site ? "" : site.error().detail.c_str());
        QVERIFY(site->manikin.isEmpty());
    }

    /// The version before has a digest, but no tools.
    void readsAFileWithoutTools()
    {
        QVERIFY(kept(test::wholeSite()).has_value());
        QByteArray before = bytes();
        before.replace("carina.site/6", "carina.site/4");
        test::writeFile(path(), before.toStdString());
        QVERIFY(!readSiteFile(path())); // the digest is of the newer one
        test::writeFile(path(), test::siteWith("'tracker': 'simulated'", "carina.site/3"));
        const auto site = readSiteFile(path());
        QVERIFY2(site.has_value(), site ? "" : site.error().detail.c_str());
        QVERIFY(site->tools.empty());
    }

    void readsBackTheTools()
    {
        const Site site = test::wholeSite();
        const auto back = kept(site);
        QVERIFY2(back.has_value(), back ? "" : back.error().detail.c_str());
        QCOMPARE(back->tools.size(), 2U);
        for (std::size_t i = 0; i < 2; ++i) {
            const SiteTool& is = back->tools[i];
            const SiteTool& was = site.tools[i];
            QCOMPARE(is.role, was.role);
            QCOMPARE(is.tool, was.tool);
            QVERIFY(near(is.X_NO, was.X_NO));
            QVERIFY(near(is.rms, was.rms) && near(is.fle, was.fle));
            QCOMPARE(is.degrees, was.degrees);
            QVERIFY(alike(is.covariance_N, was.covariance_N));
            QCOMPARE(is.touches, was.touches);
            QCOMPARE(is.calibratedAt, was.calibratedAt);
            QCOMPARE(is.operatorName, was.operatorName);
            QVERIFY(is.stale == was.stale);
            QVERIFY(near(is.p_NQ_tip(), was.p_NQ_tip()));
        }
        QVERIFY(near(back->tools[0].tube->length.si, 0.301));
        QVERIFY(back->tools[0].tube->bends == site.tools[0].tube->bends);
        QVERIFY(near(back->tools[0].check->tip.error.si, 0.4e-3));
        QCOMPARE(back->tools[0].check->at, site.tools[0].check->at);
        QVERIFY(near(back->tools[1].blade->p_L_half, site.tools[1].blade->p_L_half));
        QVERIFY(!back->tools[1].check && !back->tools[1].tube);
    }

    void refusesToolsThatNobodyHolds()
    {
        const auto refuses = [&](const auto& spoil) {
            Site site = test::wholeSite();
            spoil(site.tools);
            const auto written = writeSiteFile(path(), site);
            return !written && written.error().code == Errc::FileMalformed;
        };
        QVERIFY(refuses([](auto& tools) { tools[0].tube->length = metres(2.0); }));
        QVERIFY(refuses([](auto& tools) { tools[0].tube->bends[1] = 101.0; }));
        QVERIFY(refuses([](auto& tools) { tools[0].tube->outerDiameter = millimetres(80.0); }));
        QVERIFY(refuses([](auto& tools) { tools[1].blade->p_L_tip.z() = 0.1; }));
        QVERIFY(refuses([](auto& tools) { tools[0].degrees = 0.0; }));
        QVERIFY(refuses([](auto& tools) { tools[0].blade = tools[1].blade; }));
        QVERIFY(refuses([](auto& tools) { tools[1] = tools[0]; }));
    }

    void readsBackTheManikin()
    {
        const Site site = test::wholeSite();
        const auto back = kept(site);
        QVERIFY2(back.has_value(), back ? "" : back.error().detail.c_str());
        QVERIFY(back->manikin.profile == site.manikin.profile);
        QVERIFY(near(back->manikin.measuredTeethToCarina->si, 0.247));
        QCOMPARE(back->manikin.airway.size(), 2U);
        QVERIFY(back->manikin.airway[1].place == AirwayPlace::Carina);
        QVERIFY(near(back->manikin.airway[0].p_MQ, site.manikin.airway[0].p_MQ));
        QVERIFY(near(back->manikin.airway[1].p_MQ, site.manikin.airway[1].p_MQ));
        QCOMPARE(back->manikin.registeredAt, site.manikin.registeredAt);
    }

    /// Every figure that is offered has a source, for a profile without one is refused.
    void readsBackEveryProfileThatIsOffered()
    {
        QVERIFY(builtinManikins().size() >= 3);
        for (const ManikinProfile& profile : builtinManikins()) {
            Site site;
            site.manikin.profile = profile;
            const auto back = kept(site);
            QVERIFY2(back.has_value(), back ? "" : back.error().detail.c_str());
            QVERIFY(back->manikin.profile == profile);
        }
    }

    void readsAProfileThatAPersonWrote()
    {
        test::writeFile(path(), test::json("{'schema': 'carina.manikin/1', 'name': 'Our head',"
                                           "'teeth_to_carina': {'mm': 251, 'source': 'a tube'}}"));
        const auto profile = readManikinFile(path());
        QVERIFY2(profile.has_value(), profile ? "" : profile.error().detail.c_str());
        QCOMPARE(profile->name, std::string{"Our head"});
        QVERIFY(near(profile->teethToCarina->length.si, 0.251));
        QCOMPARE(profile->teethToCarina->source, std::string{"a tube"});
        test::writeFile(path(), test::json("{'schema': 'carina.manikin/2', 'name': 'x'}"));
        QCOMPARE(readManikinFile(path()).error().code, Errc::UnknownFormat);
        test::writeFile(path(), test::json("{'schema': 'carina.manikin/1'}"));
        QVERIFY(QString::fromStdString(readManikinFile(path()).error().detail)
                    .endsWith(QStringLiteral("site.json: name: a text is expected")));
    }

    void knowsTheStylusOfATool()
    {
        Site site = test::wholeSite();
        QCOMPARE(site.stylus("Pointer"), &site.styluses[1]);
        QVERIFY(!site.stylus("Probe"));
        site.styluses[0].tool.clear(); // of a file of the version before
        QCOMPARE(site.stylus("Probe"), &site.styluses[0]);
        QCOMPARE(site.stylus("Pointer"), &site.styluses[1]);
    }

    void leavesTheFileAsItWasWhenASiteCannotBeRead()
    {
        QVERIFY(writeSiteFile(path(), test::wholeSite()));
        const QByteArray before = bytes();
        Site site = test::wholeSite();
        site.touched[1].p_TQ.y() = std::numeric_limits<double>::quiet_NaN();
        const auto written = writeSiteFile(path(), site);
        QVERIFY(!written);
        QCOMPARE(written.error().code, Errc::FileMalformed);
        QVERIFY(written.error().detail.ends_with(
            "touched[1].p_TQ_mm: three numbers are expected, in millimetres"));
        QCOMPARE(bytes(), before);
    }

    void saysWhenItCannotWrite()
    {
        const auto written = writeSiteFile("/proc/none/site.json", Site{});
        QVERIFY(!written);
        QCOMPARE(written.error().code, Errc::FileUnwritable);
    }
};

CARINA_TEST(TestSiteFile)

} // namespace carina::site_file_test

#include "tst_site_file.moc"
