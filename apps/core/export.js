export default createCremona;
