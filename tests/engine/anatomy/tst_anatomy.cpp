#include "engine/anatomy/anatomy.h"
#include "tests/support/test_class.h"

#include <set>

namespace carina::anatomy_test
{

class TestAnatomy : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyRoleIsFoundAgainByItsName();
    void namesAreLowerCaseWords();
    void unknownNamesHaveNoRole();
    void onlyLungsHaveASide();
};

namespace
{

std::vector<PartRole> allRoles()
{
    std::vector<PartRole> roles;
    for (int i = 0; i <= static_cast<int>(PartRole::Other); ++i)
        roles.push_back(static_cast<PartRole>(i));
    return roles;
}

} // namespace

void TestAnatomy::everyRoleIsFoundAgainByItsName()
{
    std::set<std::string> names;
    for (const PartRole role : allRoles()) {
        const std::string name = roleName(role);
        QVERIFY2(names.insert(name).second, name.c_str());
        QCOMPARE(roleFromName(name), std::optional{role});
    }
    QCOMPARE(names.size(), std::size_t{31});
    QCOMPARE(std::string(roleName(PartRole::RightUpperLobe)), std::string("right_upper_lobe"));
    QCOMPARE(std::string(roleName(PartRole::Trachea)), std::string("trachea"));
    QCOMPARE(std::string(roleName(PartRole::Other)), std::string("other"));
}

void TestAnatomy::namesAreLowerCaseWords()
{
    for (const PartRole role : allRoles()) {
        for (const char c : std::string(roleName(role)))
            QVERIFY2(c == '_' || (c >= 'a' && c <= 'z'), roleName(role));
    }
}

void TestAnatomy::unknownNamesHaveNoRole()
{
    for (const char* name : {"", "Trachea", "trachea ", "lung"})
        QCOMPARE(roleFromName(name), std::optional<PartRole>{});
}

void TestAnatomy::onlyLungsHaveASide()
{
    const std::set right{PartRole::RightLung, PartRole::RightUpperLobe, PartRole::RightMiddleLobe,
                         PartRole::RightLowerLobe};
    const std::set left{PartRole::LeftLung, PartRole::LeftUpperLobe, PartRole::LeftLowerLobe};
    for (const PartRole role : allRoles()) {
        std::optional<Side> expected;
        if (right.contains(role))
            expected = Side::Right;
        if (left.contains(role))
            expected = Side::Left;
        QVERIFY2(lungSide(role) == expected, roleName(role));
    }
}

CARINA_TEST(TestAnatomy)

} // namespace carina::anatomy_test

#include "tst_anatomy.moc"
