// Times and latenesses as learning platforms write them.

#include "classroom/hand_in.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <string>

#include "system/places.h"

namespace glibra::classroom {
namespace {

TEST(HandInTimes, CountBegunDays) {
    EXPECT_EQ(daysBetween("2026-02-28", "2026-03-01 00:00"), 1);
    EXPECT_EQ(daysBetween("2028-02-28", "2028-03-01 23:59"), 2) << "a leap year";
    EXPECT_EQ(daysBetween("2026-11-20", "2026-11-01"), 0);
    EXPECT_EQ(daysBetween("2026-11-20 23:59", "2026-11-20 23:59:59"), 0) << "seconds do not count";
    EXPECT_EQ(daysBetween("2026-11-20 23:59", "2026-11-21 00:00"), 1);
}

TEST(HandInTimes, AreReadAsPlatformsWriteThem) {
    // "strftimedaydatetime" of Moodle's language packs, dotted dates, RFC 3339, and Gradescope's export.
    for (const char* each :
         {"2026-11-20 23:45", "2026-11-20T23:45:10", "2026-11-20 23:45:10.861687", "20.11.2026 23:45",
          "20.11.2026, 23:45", "Friday, 20 November 2026, 11:45 PM", "Friday, November 20, 2026, 11:45 PM",
          "Freitag, 20. November 2026, 23:45", "vendredi 20 novembre 2026, 23:45",
          "vendredi 20 novembre 2026 \xC3\xA0 23h45", "viernes, 20 de noviembre de 2026, 23:45",
          "venerd\xC3\xAC, 20 novembre 2026, 23:45", "vrijdag, 20 november 2026, 23:45",
          "Sexta-feira, 20 de novembro de 2026, 23:45"}) {
        EXPECT_TRUE(isTime(each)) << each;
        EXPECT_EQ(daysBetween("2026-11-20 23:45", each), 0) << each;
        EXPECT_EQ(daysBetween("2026-11-20 23:44", each), 1) << each;
    }
    const struct {
        const char* text;
        const char* same;
    } days[] = {{"Tuesday, 3 March 2026, 12:05 AM", "2026-03-03 00:05"},
                {"Tuesday, 3 March 2026, 12:05 PM", "2026-03-03 12:05"},
                {"mardi 3 f\xC3\xA9vrier 2026, 09:05", "2026-02-03 09:05"},
                {"martes, 3 de marzo de 2026, 09:05", "2026-03-03 09:05"},
                {"Dienstag, 3. M\xC3\xA4rz 2026, 09:05", "2026-03-03 09:05"},
                {"marted\xC3\xAC, 4 agosto 2026, 09:05", "2026-08-04 09:05"}};
    for (const auto& each : days) {
        EXPECT_EQ(daysBetween(each.same, each.text), 0) << each.text;
        EXPECT_EQ(daysBetween(each.text, each.same), 0) << each.text;
    }
    for (const char* each :
         {"", "-", "soon", "2026-13-01", "2026-02-30", "2026-11-20 25:00", "2026-11", "2026-11-20 23:59 x",
          "11/20/2026", "20 Brumaire 2026", "November 2026", "20 November", "1 May 2 June 2026",
          "2026-11-20 13:00 PM", "Never", "99999999999999999999-01-01"})
        EXPECT_FALSE(isTime(each)) << each;
    EXPECT_FALSE(isTime(std::string(100'000, '1')));
}

TEST(HandInTimes, OfAnotherZoneAreThoseOfThisMachine) {
    EXPECT_EQ(daysBetween("2026-11-20 23:59 +01:00", "2026-11-20 22:59 Z"), 0);
    EXPECT_EQ(daysBetween("2026-11-20 23:59 +0100", "2026-11-20 23:00 UTC"), 1);
    const char* before = std::getenv("TZ");
    const std::string kept = before ? before : "";
    system::setVariable("TZ", "XXX8", system::Replace::yes);  // eight hours west of Greenwich
    ::tzset();
    EXPECT_EQ(daysBetween("2026-11-20 23:59", "2026-11-21 07:59:00.861687000 Z"), 0);
    EXPECT_EQ(daysBetween("2026-11-20 23:59", "2026-11-21 08:00:00 Z"), 1);
    EXPECT_EQ(daysBetween("2026-11-20 23:59 -0800", "2026-11-20 23:59"), 0);
    if (before)
        system::setVariable("TZ", kept, system::Replace::yes);
    else
        system::removeVariable("TZ");
    ::tzset();
}

TEST(HandInTimes, LatenessIsReadAsGradescopeHasIt) {
    EXPECT_EQ(latenessOf("00:00:00"), 0);
    EXPECT_EQ(latenessOf("00:01:00"), 1);
    EXPECT_EQ(latenessOf("24:00:00"), 1);
    EXPECT_EQ(latenessOf("27:13:05"), 2);
    EXPECT_EQ(latenessOf("48:00:00"), 2);
    EXPECT_EQ(latenessOf("48:00:01"), 3) << "a second begins a day";
    for (const char* each :
         {"", "1", "1:2", "1:2:3:4", "1-2-3", "1:2:", "-1:00:00", "a:b:c", "99999999999:0:0"})
        EXPECT_FALSE(latenessOf(each)) << each;
}

TEST(HandInTimes, LatenessIsReadAsMoodleHasIt) {
    EXPECT_FALSE(readMoodleStatus("Submitted for grading").daysLate);
    EXPECT_FALSE(
        readMoodleStatus("No submission - Extension granted until: Friday, 20 November 2026").daysLate);
    EXPECT_TRUE(
        readMoodleStatus("No submission - Extension granted until: Friday, 20 November 2026").isExtended);
    EXPECT_EQ(readMoodleStatus("Submitted for grading - 1 day 3 hours late").daysLate, 2);
    EXPECT_EQ(readMoodleStatus("Submitted for grading - 3 days late - Graded").daysLate, 3);
    EXPECT_EQ(readMoodleStatus("Submitted for grading - 14 mins 3 secs late").daysLate, 1);
    EXPECT_EQ(readMoodleStatus("Submitted for grading - 1 year 2 days late").daysLate, 367);
    EXPECT_EQ(readMoodleStatus("Zur Bewertung abgegeben - 2 Tage 1 Stunde zu sp\xC3\xA4t").daysLate, 3);
    EXPECT_EQ(readMoodleStatus("Remis pour \xC3\xA9valuation - en retard de 4 jours 2 heures").daysLate, 5);
    EXPECT_EQ(readMoodleStatus("Enviado para calificar - 2 d\xC3\xAD"
                               "as despu\xC3\xA9s")
                  .daysLate,
              2);
    EXPECT_FALSE(readMoodleStatus("Submitted for grading - Extension granted until: Friday, 20 November 2026")
                     .daysLate);
}

}  // namespace
}  // namespace glibra::classroom
