// The main program of every test, and two reporters: one lists the cases for CTest, one tells of each as it begins.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>

namespace {

std::string environment(const char* name)
{
    const char* value = std::getenv(name);
    return value ? value : "";
}

// A bracket argument of CMake, in which nothing has to be escaped.
std::string bracketed(const std::string& text) { return "[====[" + text + "]====]"; }

// doctest separates the patterns of a filter with commas, unless a backslash stands before them.
std::string as_filter(const std::string& title)
{
    std::string filter;
    for (const char letter : title) {
        if (letter == ',' || letter == '\\') filter += '\\';
        filter += letter;
    }
    return filter;
}

struct Silent : doctest::IReporter {
    void report_query(const doctest::QueryData&) override {}
    void test_run_start() override {}
    void test_run_end(const doctest::TestRunStats&) override {}
    void test_case_start(const doctest::TestCaseData&) override {}
    void test_case_reenter(const doctest::TestCaseData&) override {}
    void test_case_end(const doctest::CurrentTestCaseStats&) override {}
    void test_case_exception(const doctest::TestCaseException&) override {}
    void subcase_start(const doctest::SubcaseSignature&) override {}
    void subcase_end() override {}
    void log_assert(const doctest::AssertData&) override {}
    void log_message(const doctest::MessageData&) override {}
    void test_case_skipped(const doctest::TestCaseData&) override {}
};

struct CTestList : Silent {
    explicit CTestList(const doctest::ContextOptions& options) : program(options.binary_name.c_str()) {}

    void report_query(const doctest::QueryData& query) override
    {
        std::ofstream list(environment("CREMONA_CTEST_LIST"));
        std::set<std::string> names;
        for (unsigned i = 0; i < query.num_data; ++i) {
            const std::string title = query.data[i]->m_name;
            const std::string name = environment("CREMONA_CTEST_NAME") + ": " + title;
            if (!names.insert(name).second) throw std::runtime_error("two test cases are titled " + name);
            list << "add_test(" << bracketed(name) << ' ' << bracketed(program) << ' '
                 << bracketed("--test-case=" + as_filter(title)) << ")\n"
                 << "set_tests_properties(" << bracketed(name) << " PROPERTIES WORKING_DIRECTORY "
                 << bracketed(environment("CREMONA_CTEST_DIRECTORY")) << " LABELS "
                 << bracketed("one_case;" + environment("CREMONA_CTEST_LABELS") + ";" + query.data[i]->m_test_suite)
                 << " FAIL_REGULAR_EXPRESSION \"test cases:[ ]+0 \")\n";
        }
        if (!list) throw std::runtime_error("cannot write the list of tests");
    }

    std::string program;
};

// A sanitizer ends the program where it stands; the last title then says in which case.
struct Titles : Silent {
    explicit Titles(const doctest::ContextOptions&) {}

    void test_case_start(const doctest::TestCaseData& test) override
    {
        std::cout << "begins: " << test.m_name << std::endl;
    }
};

REGISTER_REPORTER("ctest", 1, CTestList);
REGISTER_REPORTER("titles", 1, Titles);

} // namespace
